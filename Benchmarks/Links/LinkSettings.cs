namespace Nowpose.Benchmarks.Links;

/// <summary>Options of <c>links</c>.</summary>
/// <param name="KeepsOrder">Whether packets in one direction keep their order, as on most real links.</param>
/// <param name="SessionFolder">Folder for the session files; null to delete them.</param>
sealed record LinkSettings(IReadOnlyList<LinkProfile> Profiles, int Repeats, double Seconds, int Seed, bool KeepsOrder, string SessionFolder);
