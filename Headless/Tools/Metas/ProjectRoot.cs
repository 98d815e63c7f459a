namespace Nowpose.Metas;

/// <summary>Finds the Unity project that contains a folder.</summary>
public static class ProjectRoot
{
    /// <returns>The folder <paramref name="start"/> or its nearest parent folder that is a Unity project; null if there is none.</returns>
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
