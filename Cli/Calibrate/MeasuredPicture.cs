namespace Nowpose.Cli.Calibrate;

/// <summary>One picture's L_visu with what is known of its frame.</summary>
/// <param name="File">The picture; null where pairs came as a table without names.</param>
/// <param name="Vertices">The load; null where it is unknown.</param>
/// <param name="RenderMs">Δt_render of the frame; null where it is unknown.</param>
/// <param name="VisuMs">L_visu by Eq. (7).</param>
readonly record struct MeasuredPicture(string File, int? Vertices, double? RenderMs, double VisuMs);
