using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Rendering.UserMaterials;

namespace Nowpose.Unity.Tests.Rendering;

/// <summary>A part with materials of the user below a running session, and a description of how it is drawn.</summary>
sealed class PlayedMaterials : IDisposable
{
    public PlayedMaterials()
    {
        Cell = new PlayedCell();
        Session = Cell.NewSession(settings: new SessionSettings(
            new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40),
            range: new ConstantLatencyRange(15, RenderTimeSourceKind.DisplayGpuTime), outsideRange: OutsideRangeResponse.GoOn));
        var rig = Child("Robot", Session.transform).AddComponent<RobotRig>();
        Tool = Child("Tool", rig.transform).AddComponent<MeshRenderer>();
        Substitute = NewMaterial("Substitute", ("_Fade", 0), ("_Hatch", 0));
        Appearance = rig.gameObject.AddComponent<PoseAppearance>().With("_substitute", Substitute);
    }

    public PlayedCell Cell { get; }
    public MrilSession Session { get; }
    public PoseAppearance Appearance { get; }
    public Renderer Tool { get; }
    public Material Substitute { get; }

    public void BeCurrent()
    {
        Session.gameObject.SetActive(true);
        Run(5);
        Assert.That(Session.Frame.State, Is.EqualTo(PoseState.Current));
    }

    public void Run(double seconds) => Cell.Run(seconds, Session, () => { });

    public void Hold()
    {
        Cell.IsPlantUp = false;
        Run(1);
        Assert.That(Session.Frame.State, Is.EqualTo(PoseState.Held));
    }

    /// <summary>Describes how the part is drawn: "nothing", or each material with the values from its property block.</summary>
    public string Seen()
    {
        if (!Tool.isVisible) return "nothing";
        return string.Join(" | ", Tool.sharedMaterials.Select(Seen));
    }

    public string Seen(Material material, int index)
    {
        if (material == null) return "magenta";
        // A property block of one material replaces the property block of the renderer.
        var block = new MaterialPropertyBlock();
        Tool.GetPropertyBlock(block, index);
        if (block.isEmpty) Tool.GetPropertyBlock(block);
        return Seen(material, block);
    }

    public static string Seen(Material material, MaterialPropertyBlock block)
    {
        var seen = material.name;
        foreach (var name in new[] { "_Fade", "_Hatch" })
            if (material.HasProperty(name)) seen += " " + name + (block.HasFloat(name) ? block.GetFloat(name) : material.GetFloat(name));
        foreach (var name in new[] { "_Color", "_BaseColor" })
        {
            // The alpha is described only for materials that are blended by alpha, because it is not visible for others.
            if (!material.HasProperty(name) || !material.HasProperty("_SrcBlend") || material.GetFloat("_SrcBlend") != SourceAlpha) continue;
            seen += " " + (block.HasColor(Shader.PropertyToID(name)) ? block.GetColor(name) : material.GetColor(name));
        }
        return seen;
    }

    public void Dispose() => Cell.Dispose();

    static GameObject Child(string name, Transform parent)
    {
        var child = new GameObject(name);
        child.transform.SetParent(parent, false);
        return child;
    }
}
