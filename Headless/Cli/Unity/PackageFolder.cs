using System.Text.Json;
using Nowpose.Editor;

namespace Nowpose.Cli.Unity;

/// <summary>A folder with the package, and what its package.json says.</summary>
sealed class PackageFolder
{
    const string Below = "Packages/" + ProjectNeeds.Package;

    PackageFolder(string root, JsonElement description)
    {
        Root = root;
        DisplayName = description.GetProperty("displayName").GetString();
        Version = description.GetProperty("version").GetString();
        Samples =
        [
            .. description.GetProperty("samples").EnumerateArray().Select(sample => new PackageSample(
                sample.GetProperty("displayName").GetString(), sample.GetProperty("description").GetString(),
                Path.Combine(root, sample.GetProperty("path").GetString()))),
        ];
    }

    /// <summary>Absolute path.</summary>
    public string Root { get; }

    public string DisplayName { get; }
    public string Version { get; }
    public IReadOnlyList<PackageSample> Samples { get; }

    /// <summary>Finds the package of the clone that the program lies in, or the copy that a published program has beside it.</summary>
    /// <returns>Null where neither is there.</returns>
    public static PackageFolder Find()
    {
        for (var at = new DirectoryInfo(AppContext.BaseDirectory); at != null; at = at.Parent)
            if (File.Exists(Path.Combine(at.FullName, "Nowpose.slnx")) && Open(Path.Combine(at.FullName, Below)) is { } clone) return clone;
        return Open(Path.Combine(AppContext.BaseDirectory, "UnityProject", Below));
    }

    /// <returns>Null if the folder does not contain the package.</returns>
    public static PackageFolder Open(string root)
    {
        var file = Path.Combine(root, "package.json");
        if (!File.Exists(file)) return null;
        using var description = JsonDocument.Parse(File.ReadAllText(file));
        return description.RootElement.GetProperty("name").GetString() == ProjectNeeds.Package
            ? new PackageFolder(Path.GetFullPath(root), description.RootElement)
            : null;
    }
}
