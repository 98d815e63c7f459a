namespace Nowpose.Cli.Messages;

/// <summary>Steps in Unity after the command <c>unity</c>.</summary>
static class UnityNextSteps
{
    public const string InUnity =
        "Open the project in Unity. Window → Nowpose → Project Setup lists the remaining settings for a headset, and can apply most of them.";

    /// <param name="path">Folder or tarball of the package, as in the manifest.</param>
    public static string KeepPackage(string path) =>
        $"Unity reads the package from {path}. Do not move or delete it. For a new place, run the command again with --package PATH "
        + "--on-conflict replace.";

    public const string Git =
        "git must be on Unity's PATH: MRTK3 and Graphics Tools are fetched from their repositories, at the tags of their releases.";

    public const string Answers =
        "When Unity asks whether to enable the new input backend, answer Yes. When it asks whether to update the interaction layer masks, answer "
        + "No Thanks.";

    public const string Profile = "Project Settings → MRTK3, tabs Standalone and Universal Windows Platform: Assign MRTK Default.";
}
