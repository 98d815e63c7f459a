using System.Text.Json;
using Nowpose.Editor.Setup;

namespace Nowpose.Cli.Unity;

/// <summary>The folder of the package, and the content of its package.json.</summary>
sealed class PackageFolder
{
    const string Below = "Packages/" + ProjectNeeds.Package;

    PackageFolder(string root, JsonElement description)
    {
        Root = root;
        DisplayName = Text(description, "displayName");
        Version = Text(description, "version");
        Samples = ReadSamples(description);
    }

    /// <summary>Absolute path of the folder.</summary>
    public string Root { get; }

    public string DisplayName { get; }
    public string Version { get; }
    public IReadOnlyList<PackageSample> Samples { get; }

    /// <summary>Finds the package in the clone that contains this program, or the copy next to a published program.</summary>
    /// <returns>The folder; null if neither exists.</returns>
    public static PackageFolder Find()
    {
        for (var at = new DirectoryInfo(AppContext.BaseDirectory); at != null; at = at.Parent)
            if (File.Exists(Path.Combine(at.FullName, "Nowpose.slnx")) && Open(Path.Combine(at.FullName, Below)) is { } clone) return clone;
        return Open(Path.Combine(AppContext.BaseDirectory, "UnityProject", Below));
    }

    /// <returns>The folder; null if it does not contain the package.</returns>
    /// <exception cref="InputException">The package.json is not valid. The message names the file and the field.</exception>
    public static PackageFolder Open(string root)
    {
        var file = Path.Combine(root, "package.json");
        if (!File.Exists(file)) return null;
        try
        {
            using var description = JsonDocument.Parse(File.ReadAllText(file));
            if (description.RootElement.ValueKind != JsonValueKind.Object) throw new FormatException(UnityPackageMessages.ObjectExpected);
            return Text(description.RootElement, "name") == ProjectNeeds.Package
                ? new PackageFolder(Path.GetFullPath(root), description.RootElement)
                : null;
        }
        catch (JsonException e)
        {
            throw new InputException(UnityPackageMessages.NotJson(file, e.LineNumber + 1), e);
        }
        catch (FormatException e)
        {
            throw new InputException($"{file}: {e.Message}", e);
        }
    }

    IReadOnlyList<PackageSample> ReadSamples(JsonElement description)
    {
        if (!description.TryGetProperty("samples", out var samples)) return [];
        if (samples.ValueKind != JsonValueKind.Array) throw new FormatException(UnityPackageMessages.SamplesNotAnArray);
        return [.. samples.EnumerateArray().Select((sample, i) => ReadSample(sample, FormattableString.Invariant($"samples[{i}]")))];
    }

    PackageSample ReadSample(JsonElement sample, string at)
    {
        if (sample.ValueKind != JsonValueKind.Object) throw new FormatException(UnityPackageMessages.NotAnObject(at));
        return new PackageSample(
            Text(sample, "displayName", at + "."), Text(sample, "description", at + "."), Path.Combine(Root, Text(sample, "path", at + ".")));
    }

    static string Text(JsonElement parent, string name, string at = "")
    {
        try
        {
            if (parent.TryGetProperty(name, out var value) && value.ValueKind == JsonValueKind.String) return value.GetString();
        }
        catch (InvalidOperationException)
        {
            // The string contains an escape sequence for half of a surrogate pair.
        }
        throw new FormatException(UnityPackageMessages.NotAString(at, name));
    }
}

/// <summary>A sample that is listed in the package.json.</summary>
/// <param name="Name">Name shown in Unity's Package Manager.</param>
/// <param name="Description">Description of one or two sentences.</param>
/// <param name="Folder">Absolute path of the folder with the sample's files.</param>
sealed record PackageSample(string Name, string Description, string Folder);
