using System.Text.RegularExpressions;
using Nowpose.Unity;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;

namespace Nowpose.Unity.Tests.Samples;

/// <summary>Tests cameras and lights of the scenes for see-through headsets, which are all scenes except the listed desktop scenes.</summary>
public sealed class HeadsetScenesTests
{
    static readonly string[] Desktop =
    {
        "Demo.unity", "Virtual Robot Cell.unity", "Virtual Robot Cell (Two Arms).unity", "Connect to a Gateway.unity",
        "Connect to a Gateway (Any Robot).unity",
    };

    static IEnumerable<string> Scenes =>
        RepositoryFiles.All.Where(f => f.EndsWith(".unity", StringComparison.Ordinal) && !Desktop.Contains(Path.GetFileName(f)));

    [TearDown]
    public void End() => Controls.Clear();

    [Test]
    public void HeadsetScenes_InTheRepository_AreFound()
    {
        Assert.That(
            Scenes.Select(Path.GetFileName),
            Is.EquivalentTo(new[] { "Display Calibration.unity", "Any OpenXR headset.unity", "HoloLens 2 (MRTK3).unity" }));
    }

    // Unity warns while it plays a scene without an audio listener. The scene for MRTK3 has the camera and the listener of MRTK3's rig.
    [Test]
    public void SceneCameras_OfTheRepository_HaveAnAudioListener()
    {
        foreach (var path in RepositoryFiles.All.Where(f => f.EndsWith(".unity", StringComparison.Ordinal)))
        {
            var objects = Regex.Matches(RepositoryFiles.Read(path), @"(?m)^--- !u!(\d+) &").Select(m => m.Groups[1].Value).ToList();

            Assert.That(objects.Count(id => id == "81"), Is.EqualTo(objects.Count(id => id == "20")), path);
        }
    }

    [TestCaseSource(nameof(Scenes))]
    public void SceneCamera_HeadsetScene_ClearsToTransparentBlackWithPreciseDepth(string path)
    {
        using var player = Play(path);

        var camera = player.Find<Camera>();

        Assert.That(camera.backgroundColor, Is.EqualTo(new Color(0, 0, 0, 0)));
        // The rig of MRTK3 sets the camera of its scene at run time.
        if (!path.Contains("MRTK3", StringComparison.Ordinal)) Assert.That(camera.nearClipPlane, Is.EqualTo(0.1f));
        Assert.That(camera.clearFlags, Is.EqualTo(CameraClearFlags.SolidColor));
    }

    [TestCaseSource(nameof(Scenes))]
    public void SceneLights_HeadsetScene_CastNoShadows(string path)
    {
        var shadows = Regex.Matches(RepositoryFiles.Read(path), @"m_Shadows:\s+m_Type: (\d)").Select(m => m.Groups[1].Value).ToList();

        Assert.That(shadows, Is.Not.Empty.And.All.EqualTo("0"));
    }

    [TestCaseSource(nameof(Scenes))]
    public void RootObjects_HeadsetScene_AreNotDrawn(string path)
    {
        using var player = Play(path, out var roots);

        Assert.That(roots.Where(root => root.GetComponent<MeshRenderer>() != null).Select(root => root.name), Is.Empty);
    }

    [TestCase("Samples~/Display Calibration/Display Calibration.unity")]
    [TestCase("Samples~/Any OpenXR headset/Any OpenXR headset.unity")]
    public void Camera_HeadsetMoves_FollowsTheHeadset(string path)
    {
        using var player = Play(RepositoryFiles.Package + "/" + path);
        var camera = player.Find<Camera>().transform;
        player.Step(0.1);
        var alone = (camera.position, camera.rotation);

        Controls.Set("<XRHMD>/centerEyePosition", new Vector3(0.1f, 1.6f, -0.2f));
        Controls.Set("<XRHMD>/centerEyeRotation", Quaternion.Euler(10, 20, 0));
        player.Step(0.2);

        Assert.That(alone, Is.EqualTo((Vector3.zero, Quaternion.identity)));
        Assert.That(camera.position, Is.EqualTo(new Vector3(0.1f, 1.6f, -0.2f)));
        Assert.That(Quaternion.Angle(camera.rotation, Quaternion.Euler(10, 20, 0)), Is.LessThan(0.1f));
    }

    // A headset that loses its tracking reports a position at the origin. In the dark, it still measures its rotation.
    [TestCase("Samples~/Display Calibration/Display Calibration.unity", 0, 20)]
    [TestCase("Samples~/Any OpenXR headset/Any OpenXR headset.unity", 0, 20)]
    [TestCase("Samples~/Any OpenXR headset/Any OpenXR headset.unity", 2, 60)]
    public void Camera_HeadsetLosesTracking_KeepsWhatIsLost(string path, int state, float expectedTurn)
    {
        using var player = Play(RepositoryFiles.Package + "/" + path);
        var camera = player.Find<Camera>().transform;
        player.Step(0.1);
        MoveHead(new Vector3(0.1f, 1.6f, -0.2f), trackingState: 3);
        player.Step(0.2);
        var tracked = camera.localPosition;
        Assert.That(tracked, Is.Not.EqualTo(Vector3.zero));

        MoveHead(Vector3.zero, state, turn: 60);
        player.Step(0.2);

        Assert.That(camera.localPosition, Is.EqualTo(tracked));
        Assert.That(Quaternion.Angle(camera.localRotation, Quaternion.Euler(10, expectedTurn, 0)), Is.LessThan(0.1f));
    }

    static void MoveHead(Vector3 position, int trackingState, float turn = 20)
    {
        Controls.Set("<XRHMD>/centerEyePosition", position);
        Controls.Set("<XRHMD>/centerEyeRotation", Quaternion.Euler(10, turn, 0));
        Controls.Set("<XRHMD>/trackingState", trackingState);
    }

    static Player Play(string path) => Play(path, out _);

    static Player Play(string path, out IReadOnlyList<GameObject> roots)
    {
        var player = new Player(RepositoryAssets.NewLibrary());
        IReadOnlyList<GameObject> loaded = null;
        player.LoadScene(path, all =>
        {
            loaded = all;
            foreach (var session in all.SelectMany(root => root.GetComponentsInChildren<MrilSession>(true))) session.With("_connectOnEnable", false);
        });
        roots = loaded;
        return player;
    }
}
