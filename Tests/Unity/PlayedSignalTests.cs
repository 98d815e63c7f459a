using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Unity.Tests;

/// <summary>Tests planned paths, signals, and a second robot of the cell in a running scene.</summary>
public class PlayedSignalTests : PlayedParts
{
    [Test]
    public void Signal_Changing_RaisesEachEventOnceInOrderAndOnTime()
    {
        var signal = Below<CellSignal>("gripper", _session.transform);
        var seen = new List<(double Light, double Value)>();
        signal.Changed += value => seen.Add((_cell.Now + Visu, value));
        Run(1);
        SendSignal("gripper", _cell.Now - 1, 0);
        Run(0.5);
        var change = _cell.Now + 0.5;
        SendSignal("gripper", change, 1, latency: -0.4);
        SendSignal("gripper", change + 0.005, 0, latency: -0.4);

        Run(1);

        Assert.That(seen.Select(each => each.Value), Is.EqualTo(new[] { 0.0, 1, 0 }));
        Assert.That(seen[1].Light - change, Is.InRange(-1e-6, 1 / 60.0 + 1e-6), "the change is visible in the frame whose display time is its stamp");
        Assert.That(signal.Value, Is.Zero);
    }

    [Test]
    public void Signal_ListenerThrows_RaisesItsOtherEvents()
    {
        var (onTrue, onState, state, value) = (new UnityEvent(), new UnityEvent<bool>(), false, 0.0);
        onTrue.AddListener(() => throw new InvalidOperationException("a listener"));
        onState.AddListener(on => state = on);
        var signal = Below<CellSignal>("lamp", _session.transform).With("_onTrue", onTrue).With("_onState", onState);
        signal.Changed += _ => throw new InvalidOperationException("a listener");
        signal.Changed += given => value = given;
        Run(1);

        SendSignal("lamp", _cell.Now - 1, 1);
        Run(0.5);

        Assert.That((state, value), Is.EqualTo((true, 1.0)));
        Assert.That(_cell.Player.Logs.Count(log => log.Type == LogType.Exception), Is.EqualTo(2));
    }

    [TestCase(-0.08)]
    [TestCase(0)]
    [TestCase(0.06)]
    [TestCase(0.25)]
    public void Signal_MessageDelayed_RaisesEventsAtItsStampOrAtItsArrivalIfLater(double delay)
    {
        const double frame = 1 / 60.0;
        var signal = Below<CellSignal>("gripper", _session.transform);
        Run(1);
        SendSignal("gripper", _cell.Now - 1, 0);
        Run(0.5);
        var change = _cell.Now + 0.503;
        var (light, arrival) = (double.NaN, double.NaN);
        signal.Changed += _ => light = _cell.Now + Visu;

        Run(1.5, seen: () =>
        {
            if (!double.IsNaN(arrival) || _cell.Now < change + delay) return;
            arrival = _cell.Now;
            SendSignal("gripper", change, 1, arrival - change);
        });

        Assert.That(light - Math.Max(change, arrival + Visu), Is.InRange(-1e-6, frame + 1e-6));
    }

    [TestCase("0.0 mm", 12.345, "12.3 mm")]
    [TestCase("on;;off", 1, "on")]
    [TestCase("on;;off", 0, "off")]
    [TestCase("Z", 2.5, "2.5")] // not a format
    public void Signal_TextListenerAdded_ReceivesTheFormattedValue(string format, double value, string expected)
    {
        var words = Below<TextMesh>("words", _session.transform);
        var onText = new UnityEvent<string>();
        onText.Persistent.Add(PersistentCall.Of(words, "set_text", PersistentListenerMode.EventDefined, null));
        Below<CellSignal>("width", _session.transform).With("_onText", onText).With("_textFormat", format);
        Run(1);
        SendSignal("width", _cell.Now - 1, value);
        Run(0.5);

        Assert.That(words.text, Is.EqualTo(expected));
    }

    [TestCase("", "width")]
    [TestCase("Open", "Open")]
    public void Signal_MethodsWithANameAssigned_ReceiveTheParameterAndTheValue(string parameter, string expected)
    {
        var animator = Below<ParameterDouble>("animator", _session.transform);
        var (onState, onValue, onInteger) = (new UnityEvent<string, bool>(), new UnityEvent<string, float>(), new UnityEvent<string, int>());
        onState.Persistent.Add(PersistentCall.Of(animator, nameof(ParameterDouble.SetBool), PersistentListenerMode.EventDefined, null));
        onValue.Persistent.Add(PersistentCall.Of(animator, nameof(ParameterDouble.SetFloat), PersistentListenerMode.EventDefined, null));
        onInteger.Persistent.Add(PersistentCall.Of(animator, nameof(ParameterDouble.SetInteger), PersistentListenerMode.EventDefined, null));
        Below<CellSignal>("width", _session.transform)
            .With("_parameter", parameter).With("_onNamedState", onState).With("_onNamedValue", onValue).With("_onNamedInteger", onInteger);
        Run(1);

        SendSignal("width", _cell.Now - 1, 0.25);
        Run(0.5);
        SendSignal("width", _cell.Now - 0.1, 2.75);
        Run(0.5);
        SendSignal("width", _cell.Now - 0.1, 1e300);
        Run(0.5);

        Assert.That(animator.Calls, Is.EqualTo(new[]
        {
            expected + " False", expected + " 0.25", expected + " 0", expected + " True", expected + " 2.75", expected + " 3",
            expected + " Infinity", expected + " 2147483647",
        }));
    }

    [Test]
    public void Signal_ListenerEndsTheSession_NoFrameRemains()
    {
        var signal = Below<CellSignal>("jaw", _session.transform);
        signal.Changed += _ => _session.enabled = false;
        Run(1);
        SendSignal("jaw", _cell.Now - 1, 1);

        _cell.Run(0.3, _session);

        Assert.That((_session.Session, _session.Frame), Is.EqualTo(((CompensationSession)null, (DisplayFrame)null)));
        Assert.That(_cell.Player.Logs.Where(log => log.Type == LogType.Exception), Is.Empty);
    }

    [Test]
    public void Signal_NoLongerCurrentAndCurrentAgain_RaisesTheReasonOncePerChange()
    {
        var (onNotCurrent, onCurrent, onValue) = (new UnityEvent<string>(), new UnityEvent(), new UnityEvent<float>());
        var raised = new List<string>();
        onNotCurrent.AddListener(raised.Add);
        onCurrent.AddListener(() => raised.Add("current"));
        onValue.AddListener(value => raised.Add(value.ToString("0", System.Globalization.CultureInfo.InvariantCulture)));
        var signal = Below<CellSignal>("jaw", _session.transform)
            .With("_onNotCurrent", onNotCurrent).With("_onCurrent", onCurrent).With("_onValue", onValue);
        void Report(params JointReport[] reports) =>
            _session.Session.Listener.SignalStatusReceived(new JointStatusMessage(reports), HeadsetTime.FromSeconds(1000));
        Run(1);
        Assert.That(raised, Is.EqualTo(new[] { signal.Fault }), "no value has arrived");

        SendSignal("jaw", _cell.Now - 1, 1);
        Run(0.5);
        Assert.That(raised.Skip(1), Is.EqualTo(new[] { "1", "current" }));

        Report(new JointReport("jaw", JointDataState.Stale, At(0), "node deleted"));
        Run(0.5);
        Report(new JointReport("jaw", JointDataState.Stale, At(0), "no connection to the PLC"));
        Run(0.5);
        Report();
        Run(0.5);
        Assert.That(raised.Skip(3), Is.EqualTo(new[] { "node deleted", "no connection to the PLC", "current" }));

        _session.enabled = false;
        Run(0.1);
        Assert.That(raised.Skip(6), Is.EqualTo(new[] { StatusMessages.NoSession }));
        Assert.That(signal.Fault, Is.EqualTo(StatusMessages.NoSession));
    }

    // The listener of one signal disables another one, which is called later in the same frame.
    [Test]
    public void Signal_DisabledByTheListenerOfAnother_RaisesNothing()
    {
        var raised = new List<string>();
        var (disabling, counted) = (new UnityEvent(), new UnityEvent<float>());
        counted.AddListener(value => raised.Add(value.ToString("0", System.Globalization.CultureInfo.InvariantCulture)));
        Below<CellSignal>("jaw", _session.transform).With("_onCurrent", disabling);
        var other = Below<CellSignal>("door", _session.transform).With("_onValue", counted);
        disabling.AddListener(() => other.gameObject.SetActive(false));
        Run(1);
        SendSignal("door", _cell.Now - 1, 1);
        Run(0.5);
        SendSignal("jaw", _cell.Now - 1, 1);
        Run(0.5);
        SendSignal("door", _cell.Now - 0.9, 0);
        Run(0.5);
        Assert.That(raised, Is.EqualTo(new[] { "1" }));

        other.gameObject.SetActive(true);
        Run(0.5);
        SendSignal("door", _cell.Now - 0.5, 1);
        Run(0.5);

        Assert.That(raised, Is.EqualTo(new[] { "1", "0", "1" }));
    }

    // A signal that switches itself off in Start, before any value has arrived, would stay off without a trace.
    [TestCase("object")]
    [TestCase("parent")]
    [TestCase("component")]
    [TestCase("child")]
    public void Signal_EventSwitchesAnObjectOff_WarnsIfTheSignalIsThenOff(string switched)
    {
        var holder = Below<FrameProbe>("holder", _session.transform).gameObject;
        var onNotCurrent = new UnityEvent<string>();
        var lamp = Below<CellSignal>("lamp", holder.transform).With("_onNotCurrent", onNotCurrent);
        var glow = Below<FrameProbe>("glow", lamp.transform).gameObject;
        onNotCurrent.AddListener(_ =>
        {
            if (switched == "component") lamp.enabled = false;
            else (switched == "object" ? lamp.gameObject : switched == "parent" ? holder : glow).SetActive(false);
        });

        Run(1);

        Assert.That(lamp.isActiveAndEnabled, Is.EqualTo(switched == "child"));
        Assert.That(Warnings(ComponentMessages.Of("signal", "lamp", ObjectMessages.DisabledByItself)), Is.EqualTo(switched == "child" ? 0 : 1));
    }

    [Test]
    public void Signal_DisabledOutsideItsEventsOrFollowingAnotherInOne_DoesNotWarn()
    {
        var signal = Below<CellSignal>("first", _session.transform);
        signal.Changed += _ => signal.Follow(null, "second");
        Run(1);
        SendSignal("first", _cell.Now - 1, 1);
        Run(0.5);
        Assert.That(signal.Signal, Is.EqualTo("second"));

        signal.gameObject.SetActive(false);

        Assert.That(Warnings(ObjectMessages.DisabledByItself), Is.Zero);
    }

    int Warnings(string text) => _cell.Player.Logs.Count(log => log.Type == LogType.Warning && log.Message.EndsWith(text, StringComparison.Ordinal));

    // The value belongs to the name that the component follows.
    [Test]
    public void Signal_NameEditedWhileItIsFollowed_TakesEffectWhenEnabledAgain()
    {
        var rig = Below<RobotRig>("Robot", _session.transform);
        var signal = Below<CellSignal>("first", _session.transform);
        var part = Below<ActuatedPart>("first", _session.transform);
        var grip = Below<GripByReach>("first", rig.transform);
        var components = new MonoBehaviour[] { signal, part, grip };
        string[] Names() => [signal.Signal, part.Signal, grip.Signal];
        Run(1);
        SendSignal("first", _cell.Now - 1, 1);
        Run(0.5);

        foreach (var each in components) each.With("_signal", "second");
        Assert.That((signal.Value, part.Share), Is.EqualTo(((double?)1, 1f)));
        Assert.That(Names(), Is.All.EqualTo("first"));

        foreach (var each in components) each.enabled = false;
        foreach (var each in components) each.enabled = true;
        Run(0.1);
        Assert.That(Names(), Is.All.EqualTo("second"));
        Assert.That(signal.Value, Is.Null);
    }

    [Test]
    public void Signal_WithoutASession_IsReportedAsNotCurrent()
    {
        var onNotCurrent = new UnityEvent<string>();
        var raised = new List<string>();
        onNotCurrent.AddListener(raised.Add);
        new GameObject("jaw").AddComponent<CellSignal>().With("_onNotCurrent", onNotCurrent);

        _cell.Frame(null);

        Assert.That(raised, Is.EqualTo(new[] { StatusMessages.NoSession }));
    }

    [Test]
    public void Signal_NoGateway_FaultNamesTheMissingGateway()
    {
        var signal = Below<CellSignal>("gripper", _session.transform);
        Run(0.5);

        Assert.That((signal.Value, signal.Fault), Is.EqualTo(((double?)null, SignalMessages.NoConnection)));
    }
}
