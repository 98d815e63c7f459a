using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Rendering;

/// <summary>A rig with a tool, a label and a Pose Appearance below a running session, seen by a camera.</summary>
sealed class PlayedAppearance : IDisposable
{
    int _frames;

    public PlayedAppearance()
    {
        Cell = new PlayedCell();
        Session = Cell.NewSession(settings: new SessionSettings(
            new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40),
            range: new ConstantLatencyRange(15, RenderTimeSourceKind.DisplayGpuTime)));
        Rig = Child("Robot", Session.gameObject.transform).AddComponent<RobotRig>();
        Tool = Part("Tool", Rig.transform);
        Label = Child("Label", Rig.transform).AddComponent<TextMesh>();
        Label.gameObject.AddComponent<MeshRenderer>();
        Label.fontSize = 64;
        Appearance = Rig.gameObject.AddComponent<PoseAppearance>().With("_words", Label);
        Viewer = new GameObject("Camera") { tag = "MainCamera" }.AddComponent<Camera>().transform;
        Viewer.position = new Vector3(0, 1.6f, -2);
    }

    public PlayedCell Cell { get; }
    public MrilSession Session { get; }
    public Action<int> EachFrame { get; set; }
    public RobotRig Rig { get; }
    public PoseAppearance Appearance { get; }
    public Renderer Tool { get; }
    public TextMesh Label { get; }
    public Transform Viewer { get; }

    public void Play(double seconds)
    {
        Session.gameObject.SetActive(true);
        Run(seconds);
    }

    public void Run(double seconds) => Cell.Run(seconds, Session, () => EachFrame?.Invoke(_frames++));

    public (float Fade, float Hatch) Look(Renderer renderer)
    {
        var block = new MaterialPropertyBlock();
        renderer.GetPropertyBlock(block);
        return (block.GetFloat(Shader.PropertyToID("_Fade")), block.GetFloat(Shader.PropertyToID("_Hatch")));
    }

    public void BeCurrent()
    {
        Play(5);
        Assert.That(Session.Frame.State, Is.EqualTo(PoseState.Current));
    }

    public static GameObject Child(string name, Transform parent)
    {
        var child = new GameObject(name);
        child.transform.SetParent(parent, false);
        return child;
    }

    public static Renderer Part(string name, Transform parent)
    {
        var material = new Material((Shader)null) { name = name };
        material.SetFloat("_Fade", 0);
        material.SetFloat("_Hatch", 0);
        var part = Child(name, parent).AddComponent<MeshRenderer>();
        part.sharedMaterial = material;
        return part;
    }

    public void Dispose() => Cell.Dispose();
}
