using System.Text.RegularExpressions;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Profile;
using Nowpose.Messages;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Calibration;

public sealed class LatencyProfileLoaderTests
{
    const string FileName = "latency-profile.json";

    PlayedCell _cell;
    MrilSession _session;
    LatencyProfileLoader _loader;
    string _folder;

    [SetUp]
    public void SetUp()
    {
        _folder = Path.Combine(Path.GetTempPath(), "nowpose-" + Guid.NewGuid().ToString("N"));
        _cell = new PlayedCell();
        _cell.Player.World.Host.PersistentDataPath = Path.Combine(_folder, "saved");
        _cell.Player.World.Host.StreamingAssetsPath = Path.Combine(_folder, "shipped");
    }

    [TearDown]
    public void TearDown()
    {
        _cell.Dispose();
        if (Directory.Exists(_folder)) Directory.Delete(_folder, recursive: true);
    }

    string Saved => Path.Combine(_folder, "saved", FileName);
    string Shipped => Path.Combine(_folder, "shipped", FileName);

    static LatencyProfile Profile(double visuMs, string device = "Stand-in", double displayHz = 60, double? limitMs = 15) => new(
        visuMs, 1.1, device, displayHz, new DateTime(2026, 11, 20, 13, 0, 0, DateTimeKind.Utc), CalibrationMethod.VisibleLight, 300, limitMs,
        RenderTimeSourceKind.DisplayGpuTime);

    void Play(TextAsset shipped = null)
    {
        _session = _cell.NewSession();
        _loader = _session.gameObject.AddComponent<LatencyProfileLoader>().With("_shipped", shipped);
        _session.gameObject.SetActive(true);
        _cell.Run(0.1, _session);
    }

    double VisuMs => _session.Session.Visualisation.Length.TotalMilliseconds;

    [Test]
    public void OnEnable_NoProfile_KeepsTheSettingsWithoutMessage()
    {
        Play();

        Assert.That(VisuMs, Is.EqualTo(40));
        Assert.That(_loader.Profile, Is.Null);
        Assert.That(_loader.Problem, Is.Null);
        Assert.That(_cell.Messages, Has.None.Contains("latency profile"));
    }

    [Test]
    public void OnEnable_ProfilesInAllPlaces_UsesTheSavedProfile()
    {
        LatencyProfileFile.Save(Saved, Profile(51));
        LatencyProfileFile.Save(Shipped, Profile(52));

        Play(new TextAsset(LatencyProfileJson.Write(Profile(53))));

        Assert.That(VisuMs, Is.EqualTo(51));
        Assert.That(_loader.From, Is.EqualTo(Saved));
        Assert.That(_session.Statistics.Profile, Is.SameAs(_loader.Profile));
        Assert.That(_cell.Messages, Has.Exactly(1).EqualTo("[Nowpose] " + LatencyProfileMessages.Loaded(Profile(51), Saved)));
    }

    [Test]
    public void OnEnable_OnlyShippedProfiles_PrefersTheFileToTheAsset()
    {
        LatencyProfileFile.Save(Shipped, Profile(52));
        Play(new TextAsset(LatencyProfileJson.Write(Profile(53))));
        var file = VisuMs;
        File.Delete(Shipped);

        _loader.Reload();
        _cell.Frame(_session);

        Assert.That(file, Is.EqualTo(52));
        Assert.That(VisuMs, Is.EqualTo(53));
    }

    [Test]
    public void NewSession_AfterAPause_IsCalibratedBeforeItsFirstFrame()
    {
        LatencyProfileFile.Save(Saved, Profile(51));
        Play();
        var first = _session.Session;

        _cell.Player.Pause(true);
        _cell.Run(0.1, _session);
        _cell.Player.Pause(false);
        _cell.Frame(_session);

        Assert.That(_session.Session, Is.Not.Null.And.Not.SameAs(first));
        Assert.That(VisuMs, Is.EqualTo(51));
        Assert.That(_session.Statistics.RangeUnknownReason, Is.EqualTo(RangeUnknownReason.TooFewFrames), "a limit is known");
    }

    [Test]
    public void OnEnable_SavedProfileOfAnotherDevice_IsLoggedOnceAndTheNextIsUsed()
    {
        LatencyProfileFile.Save(Saved, Profile(51, device: "HoloLens 2"));
        LatencyProfileFile.Save(Shipped, Profile(52));

        Play();

        Assert.That(VisuMs, Is.EqualTo(52));
        Assert.That(_loader.Problem, Is.EqualTo($"{Saved}: {ConditionMessages.OtherDevice("HoloLens 2", "Stand-in")}"));
        Assert.That(_cell.Messages, Has.Exactly(1).EqualTo("[Nowpose] " + _loader.Problem));
    }

    [Test]
    public void Reload_InvalidFile_KeepsThePreviousProfile()
    {
        LatencyProfileFile.Save(Saved, Profile(51));
        Play();
        File.WriteAllText(Saved, LatencyProfileJson.Write(Profile(52)).Replace("\"version\": 1", "\"version\": 2", StringComparison.Ordinal));

        _loader.Reload();
        _cell.Frame(_session);

        Assert.That(VisuMs, Is.EqualTo(51));
        Assert.That(_loader.Problem, Is.EqualTo($"{Saved}: {ProfileMessages.NewerVersion(2, 1)}"));
    }

    [Test]
    public void Display_ReportsAnotherRateLater_ProfileIsRemoved()
    {
        LatencyProfileFile.Save(Saved, Profile(51));
        Play();
        var before = VisuMs;

        _cell.Player.World.Gpu.ConnectDisplay();
        _cell.Player.World.Gpu.DisplayHz = 90;
        _cell.Run(2, _session);

        Assert.That(before, Is.EqualTo(51), "the rate is not compared while it is unknown");
        Assert.That((VisuMs, _loader.Profile), Is.EqualTo((40.0, (LatencyProfile)null)));
        Assert.That(_loader.Problem, Does.EndWith(ConditionMessages.OtherRate("60", "90")));
    }

    [Test]
    public void OnEnable_ProfileOfAnotherGraphicsApi_IsUsedWithOneWarning()
    {
        LatencyProfileFile.Save(Saved, new LatencyProfile(
            51, 1, new DisplayConditions("Stand-in", 60, "Direct3D12"), DateTime.UtcNow, CalibrationMethod.VisibleLight, 300));

        Play();
        _cell.Run(3, _session);

        Assert.That(VisuMs, Is.EqualTo(51));
        Assert.That(_session.Statistics.ProfileMismatches.Single().Field, Is.EqualTo("graphics_api"));
        Assert.That(_cell.Messages, Has.Exactly(1).EqualTo(
            "[Nowpose] " + ConditionMessages.Other("graphics API", "Direct3D12", "Direct3D11", "Project Settings, Player")));
    }

    [Test]
    public void Reprojection_ChangedWhileRunning_CausesAWarning()
    {
        LatencyProfileFile.Save(Saved, new LatencyProfile(
            51, 1, new DisplayConditions("Stand-in", reprojection: ReprojectionMode.Depth), DateTime.UtcNow, CalibrationMethod.VisibleLight, 300));
        Play();
        _session.Reprojection = ReprojectionMode.Depth;
        _cell.Run(0.1, _session);
        var before = _session.Statistics.ProfileMismatches.Count;

        _session.Reprojection = ReprojectionMode.None;
        _cell.Run(0.1, _session);

        Assert.That(before, Is.Zero);
        Assert.That(_cell.Messages, Has.Exactly(1).EndsWith(
            ConditionMessages.Other("reprojection mode", "depth", "none", ConditionMessages.PlaceOfReprojection)));
    }

    [Test]
    public void StreamingAssets_InsideAnArchive_IsReportedOnlyIfNoOtherProfileExists()
    {
        _cell.Player.World.Host.StreamingAssetsPath = "jar:file:///data/app/base.apk!/assets";
        Play();
        var problem = _loader.Problem;

        LatencyProfileFile.Save(Saved, Profile(51));
        _loader.Reload();

        Assert.That(problem, Is.EqualTo(LoaderMessages.InArchive(Saved)));
        Assert.That(_loader.Problem, Is.Null);
    }

    [Test]
    public void Save_ValidProfile_IsUsedImmediatelyAndLoadedAtTheNextStart()
    {
        Play();
        var session = _session.Session;

        var isKept = _loader.Save(Profile(47));
        _cell.Frame(_session);

        Assert.That(isKept);
        Assert.That(VisuMs, Is.EqualTo(47));
        Assert.That(_session.Session, Is.SameAs(session));
        Assert.That(LatencyProfileFile.Load(Saved).Visualisation.Length.TotalMilliseconds, Is.EqualTo(47));
    }

    [Test]
    public void Save_WritingFails_UsesTheProfileAndReportsTheProblem()
    {
        Directory.CreateDirectory(Saved + ".new");
        Play();

        var isKept = _loader.Save(Profile(47));
        _cell.Frame(_session);

        Assert.That(isKept, Is.False);
        Assert.That(_loader.Problem, Does.Match($"^{FileMessages.NotSaved(Regex.Escape(Saved), "latency profile", ".+")}$"));
        Assert.That(_loader.From, Is.EqualTo(LoaderMessages.Unkept));
        Assert.That(_cell.Messages, Has.None.EndsWith("; from " + Saved), "no file has been saved");
        Assert.That(VisuMs, Is.EqualTo(47));
    }

    [Test]
    public void Save_ProfileOfAnotherDevice_IsRefused()
    {
        Play();

        Assert.That(_loader.Save(Profile(47, device: "HoloLens 2")), Is.False);
        _cell.Frame(_session);

        Assert.That(VisuMs, Is.EqualTo(40));
        Assert.That(File.Exists(Saved), Is.False);
    }

    [Test]
    public void Frames_WithAProfile_AllocateNothing()
    {
        Play();
        _cell.Run(11, _session);
        _loader.enabled = false;
        _cell.Run(1, _session);
        var without = _cell.AllocatedIn(() => _cell.Run(3, _session));

        _loader.enabled = true;
        _cell.Run(11, _session);
        var allocated = _cell.AllocatedIn(() => _cell.Run(3, _session));

        Assert.That(allocated, Is.EqualTo(without));
    }

    [Test]
    public void Nudge_SessionRestartedInUpdate_IsKept()
    {
        Play();
        var actions = _session.gameObject.AddComponent<CellActions>();
        var pairing = _session.gameObject.AddComponent<CellPairing>();
        _loader.Save(Profile(47));
        _cell.Run(0.1, _session);
        actions.SetNudgeMs(8);
        _cell.Run(0.1, _session);

        pairing.ReadCode(Pairing.PlayedPairing.Desk);
        _cell.Run(0.1, _session);
        pairing.Accept();
        _cell.Run(0.1, _session);

        Assert.That(pairing.Cell, Is.EqualTo("desk"));
        Assert.That((actions.NudgeMs, _session.Session.Visualisation.Length.TotalMilliseconds), Is.EqualTo((8f, 55.0)));
    }
}
