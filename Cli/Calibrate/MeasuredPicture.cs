namespace Nowpose.Cli.Calibrate;

/// <summary>One picture's L_visu with the known values of its frame.</summary>
/// <param name="File">Path of the picture; null if the pairs come from a table without names.</param>
/// <param name="Vertices">The load; null where it is unknown.</param>
/// <param name="RenderMs">Δt_render of the frame; null where it is unknown.</param>
/// <param name="VisuMs">L_visu by Eq. (7).</param>
readonly record struct MeasuredPicture(string File, int? Vertices, double? RenderMs, double VisuMs);
