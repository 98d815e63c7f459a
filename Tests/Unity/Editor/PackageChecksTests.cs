using Nowpose.Editor.Messages;
using Nowpose.Editor.Setup;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.PackageManager;
using PackageInfo = UnityEditor.PackageManager.PackageInfo;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>Tests the checks of the packages that a project needs.</summary>
public sealed class PackageChecksTests : EditorFixture
{
    ReviewedProject _reviewed;

    [SetUp]
    public void SetUp() => _reviewed = new ReviewedProject(this);

    [Test]
    public void UnityPackage_Missing_IsRequestedByNameAndFoundOnceInstalled()
    {
        _reviewed.Settings = new UnityProjectSettings(HeadsetPlatform.AndroidHeadset);
        _reviewed.Review = new ProjectReview(ProjectChecks.For(HeadsetPlatform.AndroidHeadset), _reviewed.Settings);
        var check = _reviewed.IndexOf("OpenXR");
        Assert.That(_reviewed.Review.Results[check].Found, Is.EqualTo(CheckResults.NotInstalled("com.unity.xr.openxr")));

        _reviewed.Review.Fix(check);
        Assert.That(Client.Asked, Is.EqualTo(new[] { "com.unity.xr.openxr" }));
        Assert.That(_reviewed.Settings.Activity, Is.EqualTo(SetupTexts.Adding("com.unity.xr.openxr")));

        Client.Newest.Succeed();
        PackageInfo.Registered.Add(new PackageInfo("com.unity.xr.openxr", "1.17.1"));
        _reviewed.Review.Refresh();

        Assert.That(_reviewed.Settings.Activity, Is.Null);
        Assert.That(_reviewed.Review.Results[check].Found, Is.EqualTo("com.unity.xr.openxr 1.17.1"));
        Assert.That(_reviewed.Review.Results[check].State, Is.EqualTo(CheckState.Good));
        PlayerSettings.Android.targetArchitectures = AndroidArchitecture.ARM64 | AndroidArchitecture.X86_64;
        _reviewed.Review.Refresh();
        Assert.That(_reviewed.Review.Results[check].State, Is.EqualTo(CheckState.Missing), "this version has no library for x86-64");
    }

    // The version that the editor recommends may no longer support the player of a HoloLens 2.
    [Test]
    public void OpenXr_MissingForAHoloLens_IsRequestedWithAVersion()
    {
        _reviewed.Review.Fix(_reviewed.IndexOf("OpenXR"));

        Assert.That(Client.Asked, Is.EqualTo(new[] { "com.unity.xr.openxr@1.13.0" }));
    }

    [Test]
    public void Package_VersionGiven_IsRequestedWithThatVersion()
    {
        _reviewed.Review.Fix(_reviewed.IndexOf("AR Foundation"));

        Assert.That(Client.Asked, Is.EqualTo(new[] { "com.unity.xr.arfoundation@5.1.5" }));
        Assert.That(_reviewed.Settings.Activity, Is.EqualTo(SetupTexts.Adding("com.unity.xr.arfoundation")));
    }

    [Test]
    public void Package_TooOld_UpdateIsRecommended()
    {
        PackageInfo.Registered.Add(new PackageInfo("com.unity.xr.arfoundation", "4.1.7"));
        PackageInfo.Registered.Add(new PackageInfo("com.microsoft.mixedreality.openxr", "1.11.1-preview"));
        _reviewed.Review.Refresh();

        var found = _reviewed.Review.Results[_reviewed.IndexOf("AR Foundation")];
        Assert.That(found.State, Is.EqualTo(CheckState.Advice));
        Assert.That(found.Found, Is.EqualTo(
            CheckResults.OutsideBounds("com.unity.xr.arfoundation", "4.1.7", isTooNew: false, "5.0.0" + CheckResults.OrNewer(new Version(6, 4, 0)))));
        Assert.That(_reviewed.Review.Results[_reviewed.IndexOf("Mixed Reality OpenXR")].State, Is.EqualTo(CheckState.Good));
    }

    [Test]
    public void AddPackage_Fails_StatesTheReason()
    {
        _reviewed.Review.Fix(_reviewed.IndexOf("NativeWebSocket (optional)"));
        Client.Newest.Fail("no git");

        Assert.That(_reviewed.Settings.Trouble, Is.EqualTo(SetupTexts.PackageNotAdded("com.endel.nativewebsocket", "no git")));
        Assert.That(_reviewed.Settings.Activity, Is.Null);
    }

    [Test]
    public void MicrosoftPackage_Missing_IsAddedToTheManifestWithItsRegistry()
    {
        using var folder = new ProjectFolder();
        folder.Write("Packages/manifest.json", "{ \"dependencies\": {} }");
        Project.Open(folder.Root);

        Project.InRoot(() =>
        {
            _reviewed.Review.Fix(_reviewed.IndexOf("Mixed Reality OpenXR"));
            return true;
        });

        Assert.That(folder.Read("Packages/manifest.json"), Does.Contain("\"com.microsoft.mixedreality.openxr\": \"1.11.2\""));
        Assert.That(folder.Read("Packages/manifest.json"), Does.Contain("pkgs.dev.azure.com"));
        Assert.That(Client.Resolved, Is.EqualTo(1));
        Assert.That(_reviewed.Settings.Trouble, Is.Null);
    }

    // A company may have its own copy of a registry. A path or a commit does not state a version, so the entry cannot be judged.
    [TestCase("""{ "scopedRegistries": [{ "name": "Own", "url": "https://mirror.example/npm", "scopes": ["com.microsoft.mixedreality"] }] }""", "https://mirror.example/npm")]
    [TestCase("""{ "dependencies": { "com.microsoft.mixedreality.openxr": "file:../OpenXR" } }""", "file:../OpenXR")]
    public void MicrosoftPackage_ManifestHasAnotherRegistryOrAPath_StatesItAndChangesNothing(string manifest, string named)
    {
        using var folder = new ProjectFolder();
        folder.Write("Packages/manifest.json", manifest);
        Project.Open(folder.Root);

        Project.InRoot(() =>
        {
            _reviewed.Review.Fix(_reviewed.IndexOf("Mixed Reality OpenXR"));
            return true;
        });

        Assert.That(_reviewed.Settings.Trouble, Does.Contain(named));
        Assert.That(folder.Read("Packages/manifest.json"), Is.EqualTo(manifest));
        Assert.That(Client.Resolved, Is.Zero);
    }

    [TestCase(null, "Could not find file")]
    [TestCase("nothing", "Packages/manifest.json:1: ")]
    public void AddPackage_ManifestInvalid_StatesTheReasonAndChangesNothing(string manifest, string reason)
    {
        using var folder = new ProjectFolder();
        folder.Write("Packages/other.txt", "");
        if (manifest != null) folder.Write("Packages/manifest.json", manifest);
        Project.Open(folder.Root);

        Project.InRoot(() =>
        {
            _reviewed.Review.Fix(_reviewed.IndexOf("Mixed Reality OpenXR"));
            return true;
        });

        Assert.That(_reviewed.Settings.Trouble, Does.StartWith(SetupTexts.PackageNotAdded("com.microsoft.mixedreality.openxr", reason)));
        Assert.That(Client.Resolved, Is.Zero);
        if (manifest != null) Assert.That(folder.Read("Packages/manifest.json"), Is.EqualTo(manifest));
    }

    [Test]
    public void PackageChecks_DependenciesOfThePackage_AreExcluded()
    {
        var manifest = RepositoryFiles.Read(RepositoryFiles.Package + "/package.json");

        var needed = ProjectChecks.ForHoloLens().Where(ReviewedProject.AddsPackage).Select(c => c.FixLabel["Add ".Length..])
            .Where(name => manifest.Contains("\"" + name + "\""));

        Assert.That(needed, Is.Empty);
    }

    [Test]
    public void OptionalPackage_Missing_IsOnlyRecommended()
    {
        var check = _reviewed.IndexOf("MRTK3 (optional)");

        Assert.That(_reviewed.Review.Results[check].State, Is.EqualTo(CheckState.Advice));
        Assert.That(_reviewed.Review.Checks[check].FixLabel, Is.Null);
        Assert.That(_reviewed.Review.Results[check].Found, Does.Contain("github.com/MixedRealityToolkit"));
    }

    [Test]
    public void Mrtk3_PartlyInstalled_NamesTheMissingPackages()
    {
        foreach (var part in new[] { "core", "uxcore", "standardassets", "uxcomponents", "spatialmanipulation", "input" })
            PackageInfo.Registered.Add(new PackageInfo("org.mixedrealitytoolkit." + part, "3.3.0"));
        _reviewed.Review.Refresh();
        Assert.That(
            _reviewed.Review.Results[_reviewed.IndexOf("MRTK3 (optional)")].Found,
            Is.EqualTo(CheckResults.NotInstalled("org.mixedrealitytoolkit.windowsspeech", 1)));

        PackageInfo.Registered.Add(new PackageInfo("org.mixedrealitytoolkit.windowsspeech", "3.0.4"));
        _reviewed.Review.Refresh();
        Assert.That(_reviewed.Review.Results[_reviewed.IndexOf("MRTK3 (optional)")].State, Is.EqualTo(CheckState.Good));

        PackageInfo.Registered.RemoveAll(p => p.name == "org.mixedrealitytoolkit.uxcomponents");
        PackageInfo.Registered.Add(new PackageInfo("org.mixedrealitytoolkit.uxcomponents", "3.2.9"));
        _reviewed.Review.Refresh();
        Assert.That(
            _reviewed.Review.Results[_reviewed.IndexOf("MRTK3 (optional)")].Found,
            Is.EqualTo(CheckResults.OutsideBounds(
                "org.mixedrealitytoolkit.uxcomponents", "3.2.9", isTooNew: false, "3.3.0" + CheckResults.OrNewer(new Version(4, 0, 0)))));
    }

    [Test]
    public void Mrtk3_AllInstalled_IsGood()
    {
        foreach (var part in new[] { "core", "uxcore", "standardassets", "uxcomponents", "spatialmanipulation", "input", "windowsspeech" })
            PackageInfo.Registered.Add(new PackageInfo("org.mixedrealitytoolkit." + part, "3.4.0"));

        _reviewed.Review.Refresh();

        Assert.That(_reviewed.Review.Results[_reviewed.IndexOf("MRTK3 (optional)")].State, Is.EqualTo(CheckState.Good));
    }

    [Test]
    public void MicrosoftPackage_Added_KeepsTheFormatOfTheManifestAndABackup()
    {
        using var folder = new ProjectFolder();
        const string before = "{\r\n\t\"dependencies\": {\r\n\t}\r\n}\r\n";
        folder.Write("Packages/manifest.json", [0xEF, 0xBB, 0xBF, .. System.Text.Encoding.UTF8.GetBytes(before)]);
        Project.Open(folder.Root);

        Project.InRoot(() =>
        {
            _reviewed.Review.Fix(_reviewed.IndexOf("Mixed Reality OpenXR"));
            return true;
        });

        var after = File.ReadAllBytes(Path.Combine(folder.Root, "Packages/manifest.json"));
        Assert.That(after.Take(3), Is.EqualTo(new byte[] { 0xEF, 0xBB, 0xBF }));
        Assert.That(System.Text.Encoding.UTF8.GetString(after), Does.Contain("{\r\n\t\t\"com.microsoft.mixedreality.openxr\": \"1.11.2\"\r\n\t}"));
        Assert.That(folder.Read("Packages/manifest.json.backup"), Is.EqualTo(before));
    }
}
