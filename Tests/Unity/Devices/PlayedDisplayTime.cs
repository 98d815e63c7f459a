using Microsoft.MixedReality.OpenXR;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.OpenXR;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Unity;
using UnityEngine;

namespace Nowpose.Unity.Tests.Devices;

/// <summary>Simulates a moving gantry, a display with varying latency, and an OpenXR runtime that predicts the display time.</summary>
sealed class PlayedDisplayTime : IDisposable
{
    const string Gantry = """
        <robot name='gantry'><link name='base'/><link name='carriage'/><joint name='x' type='prismatic'><parent link='base'/>
        <child link='carriage'/><axis xyz='1 0 0'/><limit lower='-2' upper='2' velocity='2' effort='1'/></joint></robot>
        """;

    public const double CalibratedMs = 40, VariationMs = 8, FrameMs = 1000 / 60.0;
    static readonly TimeSpan Late = TimeSpan.FromMilliseconds(80);

    double _nextSample;

    public PlayedDisplayTime()
    {
        Cell = new PlayedCell { IsPlantUp = false };
        Runtime = new PlayedRuntime(Cell.Clock);
    }

    public PlayedCell Cell { get; }
    public PlayedRuntime Runtime { get; set; }
    public MrilSession Session { get; set; }
    public OpenXrDisplayTime Component { get; private set; }

    public void Play(bool isRewritten = false)
    {
        Session = Cell.NewSession(robot: null, Settings(isRewritten));
        Session.RobotAsset = RobotDescriptionAsset.Create("gantry", Gantry);
        Component = Session.gameObject.AddComponent<OpenXrDisplayTime>();
        Runtime.Equip(Component);
        Session.gameObject.SetActive(true);
    }

    public void Run(double seconds, Action seen = null)
    {
        for (var end = Cell.Now + seconds; Cell.Now < end;)
        {
            if (Cell.Now >= _nextSample && Session.Session != null)
            {
                _nextSample = Cell.Now + 0.02;
                var taken = Cell.Clock.Read - Late;
                Session.Session.Listener.Received(
                    new JointStateMessage(new ControlTime(taken.SinceEpoch + TimeSpan.FromSeconds(300)), ["x"], [TruthAt(taken)]), Cell.Clock.Read);
            }
            Cell.Frame(Session);
            seen?.Invoke();
        }
    }

    // Runs for 12 s, and returns the RMS distance in mm between the drawn tool and its true position at the display time.
    public double ErrorMm()
    {
        double sum = 0;
        var frames = 0;
        Run(8);
        Run(12, () =>
        {
            var light = Session.Frame.Start + TrueLatency(Cell.Now);
            sum += Math.Pow(1000 * (Session.Frame.ToolPose.X - TruthAt(light)), 2);
            frames++;
        });
        return Math.Sqrt(sum / frames);
    }

    // Returns the runtime's prediction. If a frame is computed again right before rendering, the first prediction (in Update) is one frame too
    // late, because the runtime then predicts for another frame. The second prediction is exact.
    public HeadsetTime? Predicted(FrameTime tick, bool isRewritten)
    {
        var light = Cell.Clock.Read + TrueLatency(Cell.Now);
        return isRewritten && tick == FrameTime.OnUpdate ? light + TimeSpan.FromMilliseconds(FrameMs) : light;
    }

    public static SessionSettings Settings(bool isRewritten) => new(
        new ConnectionSettings("127.0.0.1", 1, 1), VisualisationLatency.FromMilliseconds(CalibratedMs), new PredictionSettings("quadratic"),
        rewriteBeforeRender: isRewritten);

    public void Dispose()
    {
        Cell.Dispose();
        Runtime.Dispose();
    }

    // Returns the true position in metres. The gantry moves back and forth at up to 0.5 m/s.
    static double TruthAt(HeadsetTime at) => 0.5 * Math.Sin(at.SinceEpoch.TotalSeconds);

    // Returns the true display latency. It alternates every half second between two values around the calibrated value.
    static TimeSpan TrueLatency(double seconds) =>
        TimeSpan.FromMilliseconds(CalibratedMs + ((int)(seconds * 2) % 2 == 0 ? VariationMs : -VariationMs));
}
