using Nowpose.Editor.Setup;

namespace Nowpose.Cli.Unity;

/// <summary>Plans and applies the changes to a Unity project.</summary>
sealed class Preparation
{
    const string InUnity = UnityNextSteps.InUnity;

    // Libraries in needed packages that projects often have in another copy, for example from NuGetForUnity.
    static readonly (string File, string Package)[] Libraries =
    [
        ("MathNet.Numerics.dll", "org.nuget.mathnet.numerics"),
        ("Newtonsoft.Json.dll", "com.unity.nuget.newtonsoft-json"),
    ];

    static readonly string[] AfterMrtk3 =
    [
        UnityNextSteps.Git,
        UnityNextSteps.Answers,
        UnityNextSteps.Profile,
    ];

    readonly List<string> _changes = [];
    readonly List<string> _notes = [];
    readonly List<SampleCopy> _samples = [];
    readonly PreparationSettings _settings;
    ManifestFile _file;
    ManifestMerge _merge;

    Preparation(UnityProject project, PreparationSettings settings)
    {
        Project = project;
        _settings = settings;
    }

    public UnityProject Project { get; }

    /// <summary>Descriptions of the changes, one line each; empty if nothing has to be changed.</summary>
    public IReadOnlyList<string> Changes => _changes;

    /// <summary>Notes for the user.</summary>
    public IReadOnlyList<string> Notes => _notes;

    /// <summary>Reason why <see cref="Apply"/> would fail, in one line; null if none is known.</summary>
    public string Obstacle => _merge.Changes.Count > 0 ? _file.Obstacle : null;

    /// <summary>Steps that the user must take after the preparation.</summary>
    public IReadOnlyList<string> NextSteps => _changes.Count == 0 ? [] : [.. OfPackage(), .. _settings.HasMrtk3 ? AfterMrtk3 : [], InUnity];

    /// <exception cref="InputException">The project cannot be prepared. It is not changed.</exception>
    public static Preparation Plan(UnityProject project, PreparationSettings settings)
    {
        var preparation = new Preparation(project, settings);
        preparation.PlanAll();
        return preparation;
    }

    /// <returns>Path of the backup of the previous manifest; null if the manifest did not change.</returns>
    /// <exception cref="InputException">The manifest is read-only, or a sample cannot be copied. The manifest is not changed.</exception>
    public string Apply()
    {
        if (Obstacle is { } obstacle) throw new InputException(obstacle);
        // Writes the manifest last, so that it does not change if a sample cannot be copied.
        foreach (var sample in _samples) sample.Apply();
        return _merge.Changes.Count > 0 ? _file.Write(_merge.Text) : null;
    }

    // A package in a folder or tarball must stay there. A package from Git or inside the project needs no step.
    IEnumerable<string> OfPackage() => PackageAddress.PathOf(_merge.VersionOf(ProjectNeeds.Package)) is { } path
        ? [UnityNextSteps.KeepPackage(path)] : [];

    void PlanAll()
    {
        var package = PackageFolder.Find()
            ?? throw new InputException(UnityPackageMessages.FilesMissing);
        _file = ManifestFile.Read(Project.ManifestPath);
        _merge = new ManifestMerge(_file.Text, Project.ManifestPath, _settings.OnConflict);
        JudgeVersions();
        NeedPackage(package);
        foreach (var needed in Needed()) if (!Project.Embeds(needed.Name)) _merge.Need(needed);
        _merge.NeedTestable(ProjectNeeds.Package);
        if (_merge.Conflicts.Count > 0) Report(_merge.Conflicts);
        _changes.AddRange(_merge.Changes);
        _notes.AddRange(_merge.Notes);
        foreach (var (file, library) in Libraries)
            _notes.AddRange(Project.Imported(file).Select(copy => UnityProjectMessages.SecondCopy(copy, library)));
        foreach (var name in _settings.Samples.Distinct(StringComparer.OrdinalIgnoreCase)) PlanSample(SampleCopy.Plan(Project, package, name));
    }

    void JudgeVersions()
    {
        var usesMicrosoft = _settings.HasMrtk3 || _merge.VersionOf(ProjectNeeds.MixedRealityOpenXr.Name) != null;
        var judged = UnityVersionRatings.Judge(Project.Version, usesMicrosoft);
        if (judged.State == CheckState.Missing) throw new InputException($"{Project.VersionPath}: {UnityProjectMessages.Version(judged.Found)}");
        if (_settings.HasMrtk3 && Project.Version.Number < UnityVersionRatings.OldestForMrtk3)
            throw new InputException(UnityProjectMessages.TooOldForMrtk3(Project.VersionPath, Project.Version, UnityVersionRatings.OldestForMrtk3));
        if (judged.State != CheckState.Good) _notes.Add(UnityProjectMessages.Version(judged.Found));
        // With MRTK3, these packages are needed, and a version that is too new is a conflict.
        if (_settings.HasMrtk3) return;
        _notes.AddRange(TooNew(ProjectNeeds.Mrtk3.Append(ProjectNeeds.XrInteraction), UnityProjectMessages.TooNew));
        if (usesMicrosoft) _notes.AddRange(TooNew([ProjectNeeds.OpenXrBefore117, ProjectNeeds.ArFoundation], UnityProjectMessages.TooNewForHoloLens));
    }

    IEnumerable<string> TooNew(IEnumerable<PackageOrigin> packages, Func<string, string, string, string> message) =>
        from package in packages
        let version = _merge.VersionOf(package.Name)
        where version != null && package.IsTooNew(version)
        select message(package.Name, version, package.Bounds);

    void NeedPackage(PackageFolder package)
    {
        if (Project.Embeds(ProjectNeeds.Package))
        {
            if (_settings.Package == null) return;
            throw new InputException(UnityProjectMessages.Embedded(Project.Root, ProjectNeeds.Package));
        }
        var address = _settings.Package == null ? PackageAddress.Of(package) : PackageAddress.Read(_settings.Package, package.Version, Project);
        var origin = PackageOrigin.At(ProjectNeeds.Package, address, min: package.Version);
        // Without --package, an entry that names a folder or a commit is kept.
        var present = _merge.VersionOf(ProjectNeeds.Package);
        if (_settings.Package == null && present != null && origin.Serves(present) == null) return;
        _merge.Need(origin, isExact: _settings.Package != null);
    }

    IEnumerable<PackageOrigin> Needed()
    {
        IEnumerable<PackageOrigin> all = ProjectNeeds.Always;
        if (_settings.HasMrtk3) all = all.Concat(ProjectNeeds.HoloLensWithMrtk3);
        return _settings.HasNativeWebSocket ? all.Append(ProjectNeeds.NativeWebSocket) : all;
    }

    void Report(IReadOnlyList<string> conflicts)
    {
        if (_settings.OnConflict != ConflictRule.Keep)
            throw new InputException(UnityProjectMessages.Conflicts(string.Join("; ", conflicts), Rules()));
        _notes.AddRange(conflicts.Select(conflict => UnityProjectMessages.EntryKept(conflict)));
    }

    string Rules() => _settings.OnConflict == ConflictRule.Refuse && _merge.CanReplaceAll ? "keep or replace" : "keep";

    void PlanSample(SampleCopy sample)
    {
        if (!sample.IsNeeded) return;
        _samples.Add(sample);
        _changes.Add(sample.Change);
        _notes.Add($"{sample.Sample.Name}: {sample.Sample.Description}");
    }
}
