using Nowpose.Editor.Setup;

namespace Nowpose.Cli.Messages;

/// <summary>Error messages of the command <c>unity</c> about the project, with remedies.</summary>
static class UnityProjectMessages
{
    public static string TooOldForMrtk3(string file, UnityVersion version, Version oldest) =>
        $"{file}: Unity {version} is older than {oldest}, the oldest version that MRTK3 supports; update Unity";

    /// <param name="finding">The version, with the problem and its remedy.</param>
    public static string Version(string finding) => $"Unity {finding}";

    public static string TooNew(string package, string version, string allowed) =>
        $"{package} {version} is not supported, so the components for MRTK3 are not compiled; allowed: {allowed}";

    public static string TooNewForHoloLens(string package, string version, string allowed) =>
        $"{package} {version} is not supported on a HoloLens 2; allowed: {allowed}";

    public static string Embedded(string project, string package) =>
        $"--package: {project} has the package in Packages/{package}, which Unity uses instead of --package; remove that folder first";

    public static string Conflicts(string conflicts, string rules) => $"{conflicts}. Correct the manifest, or use --on-conflict {rules}.";
    public static string EntryKept(string conflict) => $"{conflict}; the entry is kept";

    public static string SecondCopy(string file, string package) =>
        $"{file}: the package {package} contains this library, too, and Unity compiles no scripts with two copies; remove this file "
        + "(in NuGetForUnity: uninstall it); your scripts can use the package's copy";

    public const string Backup = "Backup of the manifest: ";
    public const string NoPath = "PROJECT is empty; enter the folder of a Unity project";

    public static string IsAFile(string path) => $"{path}: is a file; enter the folder of a Unity project";
    public static string NoFolder(string path) => $"{path}: folder not found; enter the folder of a Unity project";

    /// <param name="project">The project that contains the folder; null if none does.</param>
    public static string NotAProject(string path, string missing, string project) =>
        $"{path}: is not a Unity project: {missing} is missing; enter "
        + (project == null ? "the folder that contains Assets, Packages and ProjectSettings" : $"the project's folder {project}");

    public static string NoVersion(string file) =>
        $"{file}: no line 'm_EditorVersion: VERSION' with a version of Unity, such as 2022.3.62f1; open the project in Unity once";
}
