using Microsoft.MixedReality.OpenXR;
using Nowpose.UnityPlayer;
using UnityEngine;
using UnityEngine.XR.OpenXR;

namespace Nowpose.Unity.Tests.Devices;

/// <summary>Simulates an OpenXR display and a camera that meet all requirements for depth submission.</summary>
sealed class PlayedDisplay : IDisposable
{
    public const string DepthExtension = "XR_KHR_composition_layer_depth";

    readonly Player _player;

    public PlayedDisplay(Player player, params ReprojectionMode[] supported)
    {
        _player = player;
        player.World.Gpu.ConnectDisplay();
        player.World.Gpu.Display.AsksForDepth = true;
        OpenXRRuntime.Extensions = [DepthExtension];
        OpenXRSettings.Instance = ScriptableObject.CreateInstance<OpenXRSettings>();
        OpenXRSettings.Instance.depthSubmissionMode = OpenXRSettings.DepthSubmissionMode.Depth16Bit;
        View = new ViewConfiguration(supported.Length > 0 ? supported : Enum.GetValues<ReprojectionMode>());
        ViewConfiguration.Primary = View;
        Camera = new GameObject("Camera") { tag = "MainCamera" }.AddComponent<Camera>();
    }

    public ViewConfiguration View { get; }

    public Camera Camera { get; }

    public UnityEngine.XR.XRDisplaySubsystem Display => _player.World.Gpu.Display;

    public void Dispose()
    {
        OpenXRRuntime.Extensions = null;
        OpenXRRuntime.Fault = null;
        OpenXRSettings.Instance = null;
        ViewConfiguration.Primary = null;
    }
}
