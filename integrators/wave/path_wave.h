// SPDX-License-Identifier: Apache-2.0
// Private: how the stages of a wave follow each other.
#pragma once
#include <span>
#include <vector>

#include "integrators/direct_light.h"
#include "integrators/integrator.h"
#include "integrators/light_groups.h"
#include "integrators/light_paths.h"
#include "integrators/path_options.h"
#include "integrators/wave/shape_table.h"
#include "integrators/wave/stages.h"
#include "integrators/wave/wave.h"

namespace twinray {

/// What all waves of a render share.
struct WaveContext {
  const WaveStages& stages;
  const PathOptions& options;
  LightTransport transport;
  const Passages& passages;  ///< Of the scene; those of `transport`, if there are any.
  const BsdfTable& bsdfs;
  std::span<const ShapeEntry> shapes;   ///< shape_table().
  std::span<const PatchTable> patches;  ///< Of each light.
  std::span<const Lamp> lamps;          ///< Likewise, where there are groups of lights.
  bool has_interiors = false;           ///< Of the scene: paths must know where they are.
  bool has_flights = false;             ///< Of the scene: media scatter paths,
  bool has_uneven_glow = false;         ///< or emit light, here more than there,
  bool has_bodies = false;              ///< or surfaces let them into bodies below.
  bool has_environment = false;         ///< Of the scene: it is seen where nothing is hit.
  bool prefetches = true;               ///< Its surfaces do not stay in a cache.
  bool has_second_uvs = false;          ///< Of the scene: some textures may go by them,
  bool has_placed_textures = false;     ///< and some by the points of the scene.

  /// The shape that hits are of where media have scattered paths.
  std::uint32_t medium() const { return std::uint32_t(shapes.size()) - 1; }
};

/// The paths of up to wave_size samples, grown together vertex by vertex: all of them to their next surfaces,
/// then their shadow rays, then their bounce rays. The terms of each path are added in the order that they
/// would have if it were traced alone, so the estimates have the bits of PathReference.
class PathWave {
 public:
  /// All must outlive the wave; there is room for a record of each sample.
  PathWave(const WaveContext& context, SamplerKind kind, Tracer& tracer, Wave& wave,
           std::span<const CameraSample> samples, const RecordSpans& records);
  void trace();

 private:
  /// So many rays that leave the scene look for light together.
  static constexpr std::size_t views_together = Environment::together;

  void start();
  // Light that rays find (integrators/wave/found_light.cpp): what the hits of camera rays emit,
  void add_emission();
  /// what those see that miss,
  void add_background(std::span<const std::uint32_t> escaped);
  /// and one of them;
  void add_seen(std::size_t i, const Vec3& direction, const Rgb& radiance);
  /// what bounce rays have found of the lights,
  void add_found_light();
  /// those that have left the scene,
  void add_found_beyond(std::span<const std::uint32_t> escaped);
  /// and one of them.
  void add_found(std::size_t k, const Arrival& arrival);
  // Between surfaces (integrators/wave/media.cpp).
  /// Of paths in media that scatter: how far their rays from this vertex go, and what is needed of them.
  void take_off(std::uint32_t vertex);
  /// The ray of a path, up to where it begins.
  Way way_of(std::size_t i, const Hit& hit) const;
  /// Follows rays that are behind `depth` scattering events to their ends, through what is not there, takes
  /// from the paths what media keep on the way, and adds what they emit. Where media scatter paths, their
  /// hits are of the shape medium().
  void fly(int depth);
  /// Where the ray of a path ends.
  void land(std::size_t i, Way way, int depth);
  /// What media on its way have added.
  void add_glow(std::size_t i, const Rgb& radiance, int depth);
  void connect_through_passages();
  /// Follows the `passing` rays through what they have hit.
  void follow_passing(RayKind kind);
  /// Takes from a light's samples what interiors absorb on the way from Lambert surfaces.
  void absorb_light();
  /// Takes the paths out that have hit nothing, and those that are scattered no more.
  void drop_ended();
  void arrive();
  // Records (integrators/wave/layers.cpp): what the camera rays cover,
  void record_coverage();
  /// what is asked for of the surfaces that the paths have come to,
  void record_surfaces();
  void record_features();
  /// and which paths go on to what they see in a mirror.
  void follow_mirrors();
  // Parts of the light (integrators/wave/light_division.cpp): how paths are scattered at their first
  // surfaces,
  void keep_first_scattering();
  FirstScattering first_scattering_of(std::uint32_t sample) const {
    if (wave_.first_is_other[sample] == 0) return {};
    return {wave_.first_diffuse.at<Rgb>(sample), wave_.first_transmitted[sample] != 0};
  }
  /// what each kind of scattering brings there of a light's sample,
  void gather_scattered_light(float divisor);
  /// what each group of lights brings anywhere: by a sample of a light,
  void gather_groups(std::uint32_t light, float divisor);
  /// or by a look around,
  void gather_groups_around(float divisor);
  /// and where direct light belongs by path and by group.
  void add_direct_paths();
  void add_direct_groups();
  /// What lights bring to a path.
  LightGroups groups_of(std::size_t path) {
    const Scene& scene = context_.transport.scene;
    const std::size_t groups = scene.light_groups.size();
    return {scene, std::span(wave_.group_sums).subspan(path * groups, groups)};
  }
  PathParts paths_of(std::uint32_t sample) const { return PathParts(records_[Division::paths][sample]); }
  void expand_hits();
  /// Asks for the memory of what hits behind number i have met.
  void prefetch_surfaces(std::size_t i) const;
  /// Of a scene with textures: where the paths' cones have come to, and the draws of pixels.
  void prepare_textures();
  bool has_textures() const { return !context_.transport.scene.textures.empty(); }
  /// The surface that path `i` has come to, once its point is found.
  SurfacePoint found_surface(std::size_t i) const;
  /// Where rays leave a surface from.
  SurfacePoint point_at(std::size_t surface) const;
  /// Where textures are asked for, of all surfaces that may have any; and memory for their texels, so that
  /// none is waited for alone.
  void ask_for_texels();
  TexturePoint texture_point_at(std::size_t i) const;
  /// Where a path's textures of one set of coordinates are asked for, and how wide what it sees is there.
  void find_coordinates(std::size_t i, CoordinateSet set, float& u, float& v, float& footprint) const;
  /// Of Lambert surfaces with textures.
  void find_textured_reflectances();
  bool is_in_medium(std::size_t i) const { return wave_.hits[i].mesh == context_.medium(); }
  /// Whether lanes do not find the point of a hit: of a sphere, of an instance, or in a medium.
  bool is_placed_alone(const Hit& hit) const {
    return !context_.shapes[hit.mesh].positions || hit.instance != no_instance;
  }
  void place_others();
  /// Surfaces that are not Lambert's, and points in media (integrators/wave/other_surfaces.cpp), in lanes
  /// where these know their lobes, else alone: finds them before their normals are turned to the viewer,
  void find_others();
  /// writes their albedos and normals,
  void show_others();
  /// writes what they scatter of a light's samples, in lanes but for what interiors absorb,
  void scatter_light_at_lobes(const MisRequest& mis);
  /// and alone,
  void scatter_light_at_others(std::uint32_t light);
  /// looks for light all around them, where lanes look in the hemisphere,
  void look_around_others();
  /// remembers the throughput of the paths that have come there, which scattering in lanes overwrites,
  void keep_throughput_at_others();
  /// and chooses where these go on.
  void scatter_at_lobes();
  void scatter_at_others();
  void go_on(const OtherSurface& other, const Scattering& next);
  // Bodies below surfaces (integrators/wave/bodies.cpp): a path goes into one,
  void go_below(std::uint32_t other, const Scattering& next);
  /// all walk until they come out,
  void walk();
  /// one does, and is scattered there like at another surface;
  void come_out(const BodyWalk& walk);
  /// and their draws of roulette are those of where they come out.
  void draw_roulette_of_walks();
  /// Puts a surface on the list of its lobe, if lanes know that; of a surface that light goes below, they do
  /// not, and its light is from now on what stays above.
  bool is_listed(OtherSurface& other);
  /// How it receives light, where it is.
  void show_receiver(const OtherSurface& other);
  /// Calls f with each list and its stages.
  template <typename F>
  void for_each_lobe(F&& f);
  Departure departure_from(std::size_t surface) const;
  Receiver receiver_at(std::size_t surface) const;
  void add_direct_light();
  void add_lights();
  void add_hemisphere();
  /// The pair of draws that a purpose has, or that its one draw is in: at the current vertex,
  void draw(Purpose purpose, const SubSample& sub, Floats& x, Floats& y);
  /// or at another one.
  void draw_at(std::uint32_t vertex, Purpose purpose, const SubSample& sub, Floats& x, Floats& y);
  void sample_light(std::uint32_t light);
  void sample_mesh_light(std::uint32_t light, const MeshLight& mesh);
  void choose_of_many(const Distribution& triangles, const ShapeEntry& shape);
  void sample_sphere_light(const SphereLight& light);
  void sample_environment(const Environment& environment);
  void sample_other_light(std::uint32_t light);
  /// Of a group of lights (integrators/wave/light_choice.cpp).
  void sample_group(std::uint32_t group);
  /// The sample that surface `i` has of a light, worked out alone.
  void keep_light_sample(std::size_t i, const LightSample& sample);
  void connect();
  /// What the ray of a hemisphere sample's connection brings, once it has been followed.
  Rgb found_around(std::size_t connection);
  Interiors interiors_of(std::size_t connection) const;
  /// Whether any path may go on from its last surface.
  bool may_find_light() const;
  bool scatter(bool is_last);
  /// Of paths that have been scattered as often as limits allow.
  bool has_ended(std::size_t path) const { return context_.options.limits.are_reached(paths_.bounces[path]); }
  void count_bounces();
  /// Of paths that were scattered widely.
  void regularize_scattered();
  /// The cones of paths that were scattered, where there are textures.
  void widen_cones();
  /// Of the paths that leave their last surfaces, as all do or some, those whose rays may find light.
  std::size_t keep_light_seekers(std::size_t kept, bool is_last);
  std::size_t play_roulette(std::size_t kept);
  void compact(std::size_t kept);

  const WaveContext& context_;
  const WaveStages& stages_;
  const SamplerKind kind_;
  Tracer& tracer_;
  Wave& wave_;
  Paths& paths_;
  Surfaces& surfaces_;
  LightSamples& light_;
  Connections& connections_;
  std::span<const CameraSample> samples_;
  const RecordSpans records_;
  const std::span<Rgb> radiance_;                  ///< Of each sample.
  const bool has_light_paths_, has_light_groups_;  ///< These are asked for.
  int depth_ = 0;                                  ///< Scattering events before the current rays.
  bool is_following_ = false;  ///< Some paths were scattered by mirrors and the like alone.
};

}  // namespace twinray
