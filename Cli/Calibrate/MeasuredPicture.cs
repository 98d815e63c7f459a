namespace Nowpose.Cli.Calibrate;

/// <summary>L_visu of one picture, with vertex count and render time of the displayed frame.</summary>
/// <param name="File">Path of the picture; null if the values come from a table without file names.</param>
/// <param name="Vertices">Number of vertices in the scene; null if unknown.</param>
/// <param name="RenderMs">Δt_render of the frame, ms; null if unknown.</param>
/// <param name="VisuMs">L_visu by Eq. (7), ms.</param>
readonly record struct MeasuredPicture(string File, int? Vertices, double? RenderMs, double VisuMs);
