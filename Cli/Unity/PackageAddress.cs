using Nowpose.Editor.Setup;

namespace Nowpose.Cli.Unity;

/// <summary>Converts the value of <c>--package</c> to the package's address in a manifest.</summary>
static class PackageAddress
{
    const string File = "file:";

    static readonly string[] GitSchemes = ["https://", "http://", "ssh://", "git://", "git+https://", "git+ssh://", "git@"];

    /// <summary>Gets the address of a folder as an absolute path. A relative path would break if only the project or the clone were moved.</summary>
    public static string Of(PackageFolder folder) => File + folder.Root.Replace('\\', '/');

    /// <summary>Gets the path in an address of a folder or tarball; null for all other addresses, and for null.</summary>
    public static string PathOf(string address) => address?.StartsWith(File, StringComparison.Ordinal) == true ? address[File.Length..] : null;

    /// <param name="given">Address as entered by the user.</param>
    /// <param name="version">Version of the package that belongs to this program.</param>
    /// <param name="project">Project whose manifest will contain the address.</param>
    /// <exception cref="InputException">The address does not contain the package.</exception>
    public static string Read(string given, string version, UnityProject project)
    {
        if (GitSchemes.Any(scheme => given.StartsWith(scheme, StringComparison.Ordinal))) return Git(given, version);
        var isAddress = given.StartsWith(File, StringComparison.Ordinal);
        // Paths with file: are relative to the folder of the manifest. Other paths are relative to the working folder.
        var path = isAddress
            ? Path.Combine(project.Root, "Packages", given[File.Length..])
            : OptionPath.Read("--package", given, () => Path.GetFullPath(given));
        if (path.EndsWith(".tgz", StringComparison.Ordinal) && System.IO.File.Exists(path))
            return isAddress ? given : File + path.Replace('\\', '/');
        var folder = PackageFolder.Open(path)
            ?? throw new InputException(UnityPackageMessages.NotAnAddress(given, ProjectNeeds.Package));
        return isAddress ? given : Of(folder);
    }

    static string Git(string given, string version)
    {
        if (given.Contains("/OWNER/", StringComparison.Ordinal))
            throw new InputException(UnityPackageMessages.Owner);
        var hash = given.IndexOf('#', StringComparison.Ordinal);
        var repository = hash < 0 ? given : given[..hash];
        if (repository.Contains('?', StringComparison.Ordinal)) return given;
        return $"{repository}?path=/Packages/{ProjectNeeds.Package}{(hash < 0 ? "#v" + version : given[hash..])}";
    }
}
