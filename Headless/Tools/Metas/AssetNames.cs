namespace Nowpose.Metas;

/// <summary>Rules of Unity's importer that depend only on the name of a file or folder.</summary>
public static class AssetNames
{
    public const string MetaSuffix = ".meta";

    /// <summary>
    /// Gets whether Unity ignores a name. It ignores names with a leading dot, a trailing tilde or the extension .tmp, and the name cvs.
    /// </summary>
    public static bool IsHidden(string name)
    {
        return name.StartsWith('.') || name.EndsWith('~')
            || name.EndsWith(".tmp", StringComparison.OrdinalIgnoreCase)
            || name.Equals("cvs", StringComparison.OrdinalIgnoreCase);
    }

    public static bool IsMeta(string name) => name.EndsWith(MetaSuffix, StringComparison.OrdinalIgnoreCase);

    /// <summary>Gets whether a name is the name of a build folder of .NET. Unity would import such folders inside Assets/ and Packages/.</summary>
    public static bool IsBuildFolder(string name) => name is "bin" or "obj";

    /// <summary>Gets whether a name is the name of a build file of .NET. Unity would import such files inside Assets/ and Packages/.</summary>
    public static bool IsBuildFile(string name) => Path.GetExtension(name) is ".csproj" or ".sln" or ".slnx";
}
