using Nowpose.Session;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Status;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Rendering;

/// <summary>
/// Tests the looks and the status panel while samples come near the horizon cap. The poses are then held in some frames and current in others,
/// several times per second, and must not flash.
/// </summary>
public sealed class AlternatingPoseTests : PlayedParts
{
    const double HalfASecond = 0.5;

    readonly List<PoseState> _states = [];

    [Test]
    public void Robot_SamplesComeNearTheHorizonCap_StaysHeld()
    {
        var look = Below<RobotRig>("Robot", _session.transform).gameObject.AddComponent<PoseAppearance>();
        Run(5);
        Assert.That(look.Look.Label, Is.Empty);

        _cell.SampleSeconds = 0.25;
        var labels = LabelsIn(5, look, null, () => _session.Frame.State);

        Assert.That(Changes(_states), Is.GreaterThan(20), "the measured state alternates");
        Assert.That(Changes(labels), Is.EqualTo(1));
        Assert.That(labels[^1], Is.EqualTo(PoseMessages.Of(PoseState.Held)));
    }

    [Test]
    public void Robot_SamplesReturn_IsCurrentAfterHalfASecondOfCurrentFrames()
    {
        var look = Below<RobotRig>("Robot", _session.transform).gameObject.AddComponent<PoseAppearance>();
        Run(5);
        _cell.IsPlantUp = false;
        Run(1);
        _cell.IsPlantUp = true;

        var labels = LabelsIn(2, look, null, () => _session.Frame.State);

        var (current, shown) = (_states.IndexOf(PoseState.Current), labels.IndexOf(""));
        Assert.That((shown - current) / 60.0, Is.EqualTo(HalfASecond).Within(0.02));
        Assert.That(labels.Skip(shown), Is.All.Empty);
    }

    [Test]
    public void TrackedObject_PosesComeNearTheHorizonCap_StaysHeld()
    {
        var box = Below<TrackedObject>("box", _session.transform);
        var look = box.GetComponent<PoseAppearance>();
        Run(3, t => SendPose("world", "box", t, Along(0.1 * t)));
        Assert.That(look.Look.Label, Is.Empty);

        var labels = LabelsIn(5, look, SendRarely(), () => box.State);

        Assert.That(Changes(_states), Is.GreaterThan(20), "the measured state alternates");
        Assert.That(Changes(labels), Is.EqualTo(1));
        Assert.That(labels[^1], Is.EqualTo(PoseMessages.Of(PoseState.Held)));
    }

    [Test]
    public void StatusPanel_SamplesComeNearTheHorizonCap_ShowsTheStateOfTheLook()
    {
        var panel = new GameObject("Panel");
        panel.transform.SetParent(_session.transform, false);
        var text = Below<TextMesh>("Text", panel.transform);
        var texts = panel.AddComponent<StatusPanel>().With("_cell", text).With("_refreshSeconds", 0.1f).Texts;
        var box = Below<TrackedObject>("box", _session.transform);
        Run(5, t => SendPose("world", "box", t, Along(0.1 * t)));
        string Shown() => texts.ValueOf(StatusRow.Pose) + " | " + texts.ValueOf(StatusRow.Objects);
        Assert.That(Shown(), Is.EqualTo(PoseMessages.Of(PoseState.Current) + " | 1 current"));

        _cell.SampleSeconds = 0.25;
        var send = SendRarely();
        var shown = new List<string>();
        Run(1, send);
        Run(5, send, () =>
        {
            shown.Add(Shown());
            _states.Add(box.State);
        });

        Assert.That(Changes(_states), Is.GreaterThan(20), "the measured state alternates");
        Assert.That(shown, Is.All.EqualTo("! " + PoseMessages.Of(PoseState.Held) + " | " + StatusMessages.NotCurrent(1)));
    }

    [Test]
    public void StatusTexts_SamplesComeNearTheHorizonCap_KeepReasonAndTime()
    {
        var noon = new DateTime(2026, 11, 20, 12, 0, 0);
        var texts = new StatusTexts(() => noon + TimeSpan.FromSeconds(_cell.Now));
        var box = Below<TrackedObject>("box", _session.transform);
        Run(5, t => SendPose("world", "box", t, Along(0.1 * t)));

        _cell.SampleSeconds = 0.25;
        var send = SendRarely();
        var shown = new List<string>();
        void Read()
        {
            texts.Update(_session.Statistics, null, null, null, parts: _session.Parts);
            var rows = Enum.GetValues<StatusRow>().Where(row => row is StatusRow.Pose or >= StatusRow.Objects);
            shown.Add(string.Join(" | ", rows.Select(row => $"{texts.LabelOf(row)} {texts.ValueOf(row)} {texts.NoteOf(row)}")));
            _states.Add(box.State);
        }
        Run(1, send, Read);
        shown.Clear();
        Run(5, send, Read);

        Assert.That(Changes(_states), Is.GreaterThan(20), "the measured state alternates");
        Assert.That(shown.Distinct(), Has.Exactly(1).Items);
        Assert.That(shown[0], Does.Contain("since ").And.Contain("! object box").And.Contain("! joints "));
    }

    // Sends poses of the box so rarely that they come near the horizon cap.
    Action<double> SendRarely()
    {
        var next = _cell.Now;
        return t =>
        {
            if (_cell.Now < next) return;
            next = _cell.Now + 0.25;
            SendPose("world", "box", t, Along(0.1 * t));
        };
    }

    List<string> LabelsIn(double seconds, PoseAppearance look, Action<double> send, Func<PoseState> state)
    {
        _states.Clear();
        var labels = new List<string>();
        Run(seconds, send, () =>
        {
            _states.Add(state());
            labels.Add(look.Look.Label);
        });
        return labels;
    }

    static int Changes<T>(IReadOnlyList<T> values) => Enumerable.Range(1, values.Count - 1).Count(i => !Equals(values[i], values[i - 1]));
}
