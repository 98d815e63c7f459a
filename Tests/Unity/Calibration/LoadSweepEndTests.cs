using System.Text.RegularExpressions;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Sweep;
using Nowpose.Messages;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Calibration;

/// <summary>Tests sweeps that end early: stopped, disabled, or without a load, a folder or a valid plan.</summary>
public sealed class LoadSweepEndTests
{
    PlayedSweep _played;

    [SetUp]
    public void Begin() => _played = new PlayedSweep();

    [TearDown]
    public async Task End() => await _played.DisposeAsync();

    [Test]
    public void Reprojection_ChangesDuringTheSweep_EndsIt()
    {
        _played.Play();
        _played.Session.Reprojection = ReprojectionMode.Depth;
        _played.Run(5);
        _played.Sweep.StartSweep();
        _played.Run(0.5);

        _played.Session.Reprojection = ReprojectionMode.None;
        _played.Run(5);

        Assert.That(_played.Sweep.IsRunning, Is.False);
        Assert.That(_played.Sweep.Problem, Is.EqualTo(
            LoadSweepMessages.Changed(new ConditionMismatch(DisplayCondition.Reprojection, "depth", "none"))));
    }

    [Test]
    public async Task Stop_DuringTheSweep_KeepsTheLoggedRows()
    {
        _played.Play();
        _played.Sweep.StartSweep();
        _played.Run(6.5);
        var path = _played.Sweep.Path;

        _played.Sweep.StopSweep();
        _played.Run(0.1);

        Assert.That(_played.Sweep.IsRunning, Is.False);
        Assert.That(_played.Sweep.Words, Is.EqualTo(LoadSweepMessages.Stopped));
        Assert.That(_played.Load.Vertices, Is.EqualTo(7777));
        await Soon.BecomesAsync(() => File.Exists(path) && SweepTable.Read(path, out _).Count > 30, "the log is written");
        _played.Run(1);
        Assert.That(_played.Sweep.Verdict, Is.Null);
    }

    [Test]
    public void Disable_DuringTheSweep_StopsAndUnsubscribes()
    {
        _played.Play();
        _played.Sweep.StartSweep();
        _played.Run(5);

        _played.Sweep.enabled = false;
        _played.Run(1);

        Assert.That(_played.Sweep.IsRunning, Is.False);
        Assert.That(_played.Cell.Messages.Where(m => m.Contains("Exception", StringComparison.Ordinal)), Is.Empty);
    }

    [Test]
    public void Disable_DuringTheEvaluation_StatesThatTheSweepIsStopped()
    {
        _played.Play();
        _played.Sweep.StartSweep();

        _played.Run(20, seen: () => _played.Sweep.enabled &= _played.Sweep.Words != LoadSweepMessages.Judging);

        Assert.That((_played.Sweep.enabled, _played.Sweep.Words), Is.EqualTo((false, LoadSweepMessages.Stopped)));
    }

    [Test]
    public void StartSweep_FailsDuringTheEvaluation_StatesThatTheSweepIsStopped()
    {
        _played.Play();
        _played.Sweep.StartSweep();

        _played.Run(20, seen: () =>
        {
            if (_played.Sweep.Words != LoadSweepMessages.Judging) return;
            _played.Sweep.With("_steps", 1).StartSweep();
        });

        Assert.That(_played.Sweep.Problem, Is.Not.Null);
        Assert.That(_played.Sweep.Words, Is.EqualTo(LoadSweepMessages.Stopped));
    }

    [Test]
    public void StartSweep_ByAListenerDuringTheEvaluation_IsCalledOnce()
    {
        _played.Play();
        _played.Sweep.StartSweep();
        var calls = 0;
        _played.Sweep.Progressed += () =>
        {
            if (_played.Sweep.Words != LoadSweepMessages.Stopped || ++calls > 9) return;
            _played.Sweep.StartSweep();
        };

        _played.Run(20, seen: () =>
        {
            if (_played.Sweep.Words == LoadSweepMessages.Judging) _played.Sweep.With("_steps", 1).StartSweep();
        });

        Assert.That(calls, Is.EqualTo(1));
    }

    [Test]
    public async Task Log_CannotBeWrittenAtTheEnd_StatesThatTheSweepIsStopped()
    {
        _played.Play();
        _played.Sweep.StartSweep();
        var path = _played.Sweep.Path;
        for (var end = _played.Cell.Now + 20; _played.Sweep.Words?.StartsWith("load 5 of 5", StringComparison.Ordinal) != true && _played.Cell.Now < end;)
            _played.Run(0.01);
        bool IsFull(SweepRow row) => row.Vertices == 100_000;
        await Soon.BecomesAsync(() => SweepTable.Read(path, out _).SkipWhile(row => !IsFull(row)).SkipWhile(IsFull).Any(), "the fourth load is written");

        File.Delete(path);
        Directory.CreateDirectory(path);
        var isEvaluated = false;
        _played.Run(5, seen: () => isEvaluated |= _played.Sweep.Words == LoadSweepMessages.Judging);
        await _played.Judged();

        Assert.That((isEvaluated, _played.Sweep.Verdict, _played.Sweep.Words), Is.EqualTo((true, (LoadSensitivity)null, LoadSweepMessages.Stopped)));
        Assert.That(_played.Sweep.Problem, Is.Not.Null);
    }

    [Test]
    public async Task Folder_CannotBeCreated_IsLoggedOnceAndEndsTheSweep()
    {
        File.WriteAllText(_played.Folder, "a file where the folder should be");
        _played.Play();
        _played.Sweep.StartSweep();
        _played.Run(12);
        await _played.Judged();

        Assert.That(_played.Sweep.Problem, Does.Match($"^{SweepMessages.LogNotWritten(Regex.Escape(_played.Sweep.Path), ".+")}$"));
        Assert.That(_played.Cell.Messages.Count(m => m.Contains(_played.Sweep.Problem, StringComparison.Ordinal)), Is.EqualTo(1));
        Assert.That(_played.Load.Vertices, Is.EqualTo(7777));
    }

    [Test]
    public void Load_CannotBeDrawn_EndsTheSweepWithItsProblem()
    {
        _played.Play(isPainted: false);
        _played.Sweep.StartSweep();

        _played.Run(5);

        Assert.That(_played.Sweep.IsRunning, Is.False);
        Assert.That(_played.Sweep.Problem, Is.EqualTo("load generator 'Load' " + ComponentMessages.NoMaterial));
        Assert.That(_played.Sweep.Words, Is.EqualTo(LoadSweepMessages.Stopped));
    }

    [Test]
    public async Task Load_DisabledDuringTheSweep_EndsItAndKeepsTheLoggedRows()
    {
        _played.Play();
        _played.Sweep.StartSweep();
        _played.Run(6.5);

        _played.Load.enabled = false;
        _played.Run(1);

        Assert.That(_played.Sweep.IsRunning, Is.False);
        Assert.That(_played.Sweep.Problem, Is.EqualTo(LoadSweepMessages.GeneratorOff("Load")));
        Assert.That(_played.Cell.Messages.Count(m => m.Contains(LoadSweepMessages.GeneratorOff("Load"), StringComparison.Ordinal)), Is.EqualTo(1));
        Assert.That(_played.Load.Vertices, Is.EqualTo(7777), "as before");
        await Soon.BecomesAsync(() => File.Exists(_played.Sweep.Path) && SweepTable.Read(_played.Sweep.Path, out _).Count > 30, "the log is written");
    }

    [TestCase("load generator")]
    [TestCase("session")]
    public void Part_DestroyedDuringTheSweep_EndsIt(string part)
    {
        _played.Play();
        _played.Sweep.StartSweep();
        _played.Run(5);

        UnityEngine.Object.Destroy(part == "session" ? (UnityEngine.Object)_played.Session : _played.Load.gameObject);
        _played.Run(1, gpuSeesLoad: false);

        Assert.That(_played.Sweep.IsRunning, Is.False);
        Assert.That(_played.Sweep.Problem, Is.EqualTo(LoadSweepMessages.Destroyed(_played.Sweep.name, part)));
        Assert.That(_played.Cell.Messages.Where(m => m.Contains("Exception", StringComparison.Ordinal)), Is.Empty);
    }

    [Test]
    public void StartSweep_ComponentMissing_IsReported()
    {
        var sweep = new GameObject("Alone").AddComponent<LoadSweep>();

        sweep.StartSweep();

        Assert.That(sweep.Problem, Is.EqualTo(ComponentMessages.ComponentWithoutSession("load sweep", "Alone")));
        Assert.That(sweep.IsRunning, Is.False);
    }

    [Test]
    public void StartSweep_Disabled_IsReported()
    {
        _played.Play();
        _played.Sweep.enabled = false;

        _played.Sweep.StartSweep();

        Assert.That(_played.Sweep.Problem, Is.EqualTo("load sweep 'Cell' " + ComponentMessages.SweepDisabled));
        Assert.That(_played.Sweep.IsRunning, Is.False);
    }

    [Test]
    public void StartSweep_PlanOutOfRange_IsReported()
    {
        _played.Play();
        _played.Sweep.With("_steps", 1);

        _played.Sweep.StartSweep();

        Assert.That(_played.Sweep.Problem, Does.Contain(SettingMessages.OutOfRange(SettingNames.SweepSteps, 1, "", 2, 100)));
    }
}
