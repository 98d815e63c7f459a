namespace Nowpose.Metas;

/// <summary>Rules of Unity's importer that depend only on the name of a file or folder.</summary>
public static class AssetNames
{
    public const string MetaSuffix = ".meta";

    /// <summary>
    /// Returns whether Unity ignores files and folders of this name: names with a leading dot, a trailing tilde or the extension .tmp, and the name
    /// cvs.
    /// </summary>
    public static bool IsHidden(string name)
    {
        return name.StartsWith('.') || name.EndsWith('~')
            || name.EndsWith(".tmp", StringComparison.OrdinalIgnoreCase)
            || name.Equals("cvs", StringComparison.OrdinalIgnoreCase);
    }

    public static bool IsMeta(string name) => name.EndsWith(MetaSuffix, StringComparison.OrdinalIgnoreCase);

    /// <summary>Returns whether .NET gives its build folders this name. Unity would import such folders inside Assets/ and Packages/.</summary>
    public static bool IsBuildFolder(string name) => name is "bin" or "obj";

    /// <summary>
    /// Returns whether this is a file name of a .NET project or solution. Unity would import such files inside Assets/ and Packages/.
    /// </summary>
    public static bool IsBuildFile(string name) => Path.GetExtension(name) is ".csproj" or ".sln" or ".slnx";
}
