namespace Nowpose.Metas;

/// <summary>Finds the Unity project that contains a folder.</summary>
public static class ProjectRoot
{
    /// <returns>The nearest folder at or above <paramref name="start"/> that is a Unity project, or null.</returns>
    public static string Find(string start)
    {
        var folder = new DirectoryInfo(start);
        while (folder != null && !IsProject(folder.FullName)) folder = folder.Parent;
        return folder?.FullName;
    }

    static bool IsProject(string folder)
    {
        return File.Exists(Path.Combine(folder, "Packages", "manifest.json"))
            && File.Exists(Path.Combine(folder, "ProjectSettings", "ProjectVersion.txt"));
    }
}
