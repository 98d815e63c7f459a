using Nowpose.Editor;
using Nowpose.Editor.Setup;

namespace Nowpose.Cli.Unity;

/// <summary>Reads <c>--package</c>: where a manifest finds the package.</summary>
static class PackageAddress
{
    const string File = "file:";

    static readonly string[] GitSchemes = ["https://", "http://", "ssh://", "git://", "git+https://", "git+ssh://", "git@"];

    /// <summary>The address of a folder, absolute: a project and a clone are moved one without the other.</summary>
    public static string Of(PackageFolder folder) => File + folder.Root.Replace('\\', '/');

    /// <param name="given">What the user typed.</param>
    /// <param name="version">The version of the package that this program belongs to.</param>
    /// <param name="project">The project in whose manifest the address is written.</param>
    /// <exception cref="InputException">Nothing can be found there.</exception>
    public static string Read(string given, string version, UnityProject project)
    {
        if (GitSchemes.Any(scheme => given.StartsWith(scheme, StringComparison.Ordinal))) return Git(given, version);
        var isAddress = given.StartsWith(File, StringComparison.Ordinal);
        // What stands in a manifest is relative to the folder of the manifest; what is typed, to the working folder.
        var path = isAddress ? Path.Combine(project.Root, "Packages", given[File.Length..]) : Path.GetFullPath(given);
        if (path.EndsWith(".tgz", StringComparison.Ordinal) && System.IO.File.Exists(path))
            return isAddress ? given : File + path.Replace('\\', '/');
        var folder = PackageFolder.Open(path)
            ?? throw new InputException(
                $"--package: '{given}' is neither a git address nor a folder or tarball with the package {ProjectNeeds.Package}");
        return isAddress ? given : Of(folder);
    }

    static string Git(string given, string version)
    {
        if (given.Contains("/OWNER/", StringComparison.Ordinal))
            throw new InputException("--package: put the host of your copy of the repository in the place of OWNER");
        var hash = given.IndexOf('#', StringComparison.Ordinal);
        var repository = hash < 0 ? given : given[..hash];
        if (repository.Contains('?', StringComparison.Ordinal)) return given;
        return $"{repository}?path=/Packages/{ProjectNeeds.Package}{(hash < 0 ? "#v" + version : given[hash..])}";
    }
}
