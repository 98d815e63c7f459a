using Nowpose.UnityPlayer.Assets.Objects;
using Nowpose.UnityPlayer.Assets.Yaml;

namespace Nowpose.Prefabs;

/// <summary>Creates the objects around the robot in a desktop scene.</summary>
static class Props
{
    /// <summary>Creates the camera of a desktop scene.</summary>
    /// <param name="position">Position in metres.</param>
    /// <param name="eulerAngles">Euler angles in degrees.</param>
    public static GameObject Camera(Vector3 position, Vector3 eulerAngles)
    {
        var camera = HeadsetCamera();
        camera.transform.position = position;
        camera.transform.eulerAngles = eulerAngles;
        var settings = camera.GetComponent<Camera>();
        settings.backgroundColor = new Color(0.1f, 0.11f, 0.13f, 0);
        settings.nearClipPlane = 0.05f;
        settings.fieldOfView = 50;
        return camera;
    }

    /// <summary>
    /// Creates a camera that a headset moves. Its background is black, which a see-through display shows as transparent. With a near clip plane at
    /// 0.1 m, a step of a 16-bit depth buffer is 0.34 mm at 1.5 m; at 0.02 m it would be 1.7 mm.
    /// </summary>
    public static GameObject HeadsetCamera()
    {
        var camera = new GameObject("Main Camera") { tag = "MainCamera" };
        var settings = camera.AddComponent<Camera>();
        settings.clearFlags = CameraClearFlags.SolidColor;
        settings.backgroundColor = new Color(0, 0, 0, 0);
        settings.nearClipPlane = 0.1f;
        settings.farClipPlane = 100;
        settings.depth = -1;
        // Unity warns while it plays a scene without an audio listener.
        var listener = camera.AddComponent<OpaqueComponent>();
        listener.ClassName = "AudioListener";
        listener.Fields.Add("m_Enabled", Nodes.Number(1));
        return camera;
    }

    /// <summary>
    /// Creates a directional light. The scene of a headset has no shadows, because they need a second rendering pass, and a headset's display cannot
    /// darken the room.
    /// </summary>
    public static GameObject Light(bool hasShadows = true)
    {
        var light = new GameObject("Directional Light");
        light.transform.position = new Vector3(0, 3, 0);
        light.transform.eulerAngles = new Vector3(50, -30, 0);
        var component = light.AddComponent<OpaqueComponent>();
        component.ClassName = "Light";
        foreach (var (name, value) in LightFields(hasShadows).Children) component.Fields.Add(name, value);
        return light;
    }

    /// <summary>Creates a ground of 4 m × 4 m at the height of the robot's base.</summary>
    public static GameObject Ground(PackageAssets assets)
    {
        var material = assets.Load<Material>(PackagePaths.Solid);
        var ground = Children.AddPrimitive(PrimitiveType.Quad, "Ground", null, Vector3.zero, new Vector3(4, 4, 1), material);
        ground.transform.eulerAngles = new Vector3(90, 0, 0);
        return ground;
    }

    static YamlDotNet.RepresentationModel.YamlMappingNode LightFields(bool hasShadows) => Nodes.Lines(
        ("m_Enabled", Nodes.Number(1)),
        ("serializedVersion", Nodes.Number(10)),
        ("m_Type", Nodes.Number(1)),
        ("m_Shape", Nodes.Number(0)),
        ("m_Color", Nodes.Braces(("r", Nodes.Number(1)), ("g", Nodes.Text("0.96")), ("b", Nodes.Text("0.9")), ("a", Nodes.Number(1)))),
        ("m_Intensity", Nodes.Number(1)),
        ("m_Shadows", Nodes.Lines(
            ("m_Type", Nodes.Number(hasShadows ? 2 : 0)),
            ("m_Resolution", Nodes.Number(-1)),
            ("m_CustomResolution", Nodes.Number(-1)),
            ("m_Strength", Nodes.Number(1)),
            ("m_Bias", Nodes.Text("0.05")),
            ("m_NormalBias", Nodes.Text("0.4")),
            ("m_NearPlane", Nodes.Text("0.2")))));
}
