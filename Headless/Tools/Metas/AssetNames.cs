namespace Nowpose.Metas;

/// <summary>Rules of Unity's importer that depend on a name alone.</summary>
public static class AssetNames
{
    public const string MetaSuffix = ".meta";

    /// <summary>Whether Unity ignores the file: leading dot, trailing tilde, <c>.tmp</c>, <c>cvs</c>.</summary>
    public static bool IsHidden(string name)
    {
        return name.StartsWith('.') || name.EndsWith('~')
            || name.EndsWith(".tmp", StringComparison.OrdinalIgnoreCase)
            || name.Equals("cvs", StringComparison.OrdinalIgnoreCase);
    }

    public static bool IsMeta(string name) => name.EndsWith(MetaSuffix, StringComparison.OrdinalIgnoreCase);

    /// <summary>Build files and folders of .NET: harmless beside Assets/ and Packages/, imported as assets inside them.</summary>
    public static bool IsBuildFolder(string name) => name is "bin" or "obj";

    /// <inheritdoc cref="IsBuildFolder"/>
    public static bool IsBuildFile(string name) => Path.GetExtension(name) is ".csproj" or ".sln" or ".slnx";
}
