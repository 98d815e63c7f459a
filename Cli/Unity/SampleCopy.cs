using Nowpose.Gateway.Options;

namespace Nowpose.Cli.Unity;

/// <summary>Copies a sample, including its .meta files, to the folder that Unity's Package Manager uses.</summary>
sealed class SampleCopy
{
    readonly string _source, _target;
    readonly List<string> _missing;

    SampleCopy(PackageSample sample, string source, string target, List<string> missing)
    {
        Sample = sample;
        _source = source;
        _target = target;
        _missing = missing;
    }

    public PackageSample Sample { get; }

    /// <summary>Whether any file must be copied.</summary>
    public bool IsNeeded => _missing.Count > 0;

    /// <summary>Description of the change in one line.</summary>
    public string Change => FormattableString.Invariant($"sample: {Sample.Name}, {_missing.Count} files to {_target}");

    /// <exception cref="InputException">
    /// The package has no such sample, a file in the project differs from the sample's, the project has the sample of another version, or a file has
    /// the name of a needed folder.
    /// </exception>
    public static SampleCopy Plan(UnityProject project, PackageFolder package, string name)
    {
        var sample = package.Samples.FirstOrDefault(s => string.Equals(s.Name, name, StringComparison.OrdinalIgnoreCase))
            ?? throw new InputException(UnityPackageMessages.UnknownSample(name, string.Join(", ", package.Samples.Select(s => s.Name))));
        if (!Directory.Exists(sample.Folder))
            throw new InputException(UnityPackageMessages.SampleMissing(sample.Name, sample.Folder));
        var target = Path.Combine(project.Root, "Assets", "Samples", package.DisplayName, package.Version, sample.Name);
        for (var folder = target; folder != project.Root; folder = Path.GetDirectoryName(folder))
            if (File.Exists(folder))
                throw new InputException(UnityPackageMessages.FileInTheWay(folder));
        // Two copies of a sample have the same GUIDs and assembly names, and Unity compiles neither.
        if (OtherVersions(target).FirstOrDefault() is { } other)
            throw new InputException(UnityPackageMessages.OtherVersion(other, sample.Name));
        var files = Directory.EnumerateFiles(sample.Folder, "*", SearchOption.AllDirectories)
            .Select(file => Path.GetRelativePath(sample.Folder, file)).Order(StringComparer.Ordinal).ToList();
        var present = files.Where(file => File.Exists(Path.Combine(target, file))).ToList();
        var changed = present.Where(file => !IsSame(Path.Combine(sample.Folder, file), Path.Combine(target, file))).ToList();
        if (changed.Count > 0)
            throw new InputException(UnityPackageMessages.SampleChanged(Path.Combine(target, changed[0]), changed.Count - 1));
        return new SampleCopy(sample, sample.Folder, target, [.. files.Except(present)]);
    }

    /// <summary>Copies the missing files. A new folder appears only when it is complete, and each file too.</summary>
    /// <exception cref="InputException">A file cannot be copied.</exception>
    public void Apply() => FileFault.Report(Copy, e => UnityPackageMessages.NotCopied(_target, Sample.Name, e.Message.TrimEnd('.')));

    // Returns the folders of the same sample that belong to other versions of the package.
    static IEnumerable<string> OtherVersions(string target)
    {
        var versions = Path.GetDirectoryName(Path.GetDirectoryName(target));
        return Directory.Exists(versions)
            ? Directory.EnumerateDirectories(versions).Order(StringComparer.Ordinal)
                .Select(version => Path.Combine(version, Path.GetFileName(target))).Where(copy => copy != target && Directory.Exists(copy))
            : [];
    }

    void Copy()
    {
        // Copies to a temporary folder. Unity ignores it because its name begins with a dot.
        var unfinished = Path.Combine(Path.GetDirectoryName(_target), "." + Path.GetFileName(_target));
        RemoveFolder(unfinished);
        try
        {
            foreach (var file in _missing) Transfer(File.Copy, Path.Combine(_source, file), Path.Combine(unfinished, file));
            if (!Directory.Exists(_target)) Directory.Move(unfinished, _target);
            else foreach (var file in _missing) Transfer(File.Move, Path.Combine(unfinished, file), Path.Combine(_target, file));
        }
        finally
        {
            RemoveFolder(unfinished);
        }
    }

    static void Transfer(Action<string, string> transfer, string from, string to)
    {
        Directory.CreateDirectory(Path.GetDirectoryName(to));
        transfer(from, to);
    }

    static void RemoveFolder(string folder)
    {
        if (Directory.Exists(folder)) Directory.Delete(folder, recursive: true);
    }

    static bool IsSame(string a, string b) => ContentOf(a).SequenceEqual(ContentOf(b));

    // Ignores carriage returns before line ends, because Git on Windows adds them.
    static IEnumerable<byte> ContentOf(string path)
    {
        var bytes = File.ReadAllBytes(path);
        return bytes.Where((one, i) => one != '\r' || i + 1 == bytes.Length || bytes[i + 1] != '\n');
    }
}
