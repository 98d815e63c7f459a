using Nowpose.Unity.Tests.Engine.Scripts;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.XR;

namespace Nowpose.Unity.Tests.Engine.Rendering;

public sealed class GpuTests : PlayerFixture
{
    readonly List<XRDisplaySubsystem> _displays = [];

    [Test]
    public void Display_NotConnected_IsNotFound()
    {
        SubsystemManager.GetSubsystems(_displays);

        Assert.That(_displays, Is.Empty);
    }

    [TestCase(null, false, 0)]
    [TestCase(0.008f, true, 0.008f)]
    public void Display_GpuTime_IsTheGivenValue(float? time, bool known, float expected)
    {
        Player.World.Gpu.ConnectDisplay();
        Player.World.Gpu.DisplayGpuTime = time;
        SubsystemManager.GetSubsystems(_displays);

        Assert.That(_displays.Single().running);
        Assert.That((_displays[0].TryGetAppGPUTimeLastFrame(out var seconds), seconds), Is.EqualTo((known, expected)));
        _displays[0].Stop();
        Assert.That(_displays[0].TryGetAppGPUTimeLastFrame(out _), Is.False);
    }

    [Test]
    public void FrameTimings_Requested_ReturnTheAvailableTimings()
    {
        var timings = new FrameTiming[3];
        FrameTimingManager.CaptureFrameTimings();
        Assert.That(FrameTimingManager.GetLatestTimings(3, timings), Is.Zero);

        Player.World.Gpu.FrameTimings.Add(new FrameTiming { gpuFrameTime = 7.5 });

        Assert.That(FrameTimingManager.GetLatestTimings(3, timings), Is.EqualTo(1));
        Assert.That(timings[0].gpuFrameTime, Is.EqualTo(7.5));
    }

    [TestCase(1)]
    [TestCase(3)]
    public void Readback_Requested_CompletesAfterTheSetNumberOfFrames(int frames)
    {
        Player.World.Gpu.ReadbackFrames = frames;
        Frame();
        var request = AsyncGPUReadback.Request(new Texture2D(1, 1), 0, r => Journal.Note($"done {r.done} {r.hasError}"));

        Assert.That(Frame(frames - 1), Is.Empty);
        Assert.That(request.done, Is.False);
        Assert.That(Frame(), Is.EqualTo("done True False"));
        Assert.That((request.done, request.hasError, Frame(3)), Is.EqualTo((true, false, "")));
    }

    [Test]
    public void Readback_NotSupported_CompletesWithAnError()
    {
        Assert.That(SystemInfo.supportsAsyncGPUReadback, Is.False);

        AsyncGPUReadback.Request(new Texture2D(1, 1), 0, r => Journal.Note($"{r.hasError}"));

        Assert.That(Frame(), Is.EqualTo("True"));
    }

    [Test]
    public void Readback_RequestedInEachFrame_CompletesEachAndAllocatesNothing()
    {
        Player.World.Gpu.ReadbackFrames = 1;
        var texture = new Texture2D(1, 1);
        Action<AsyncGPUReadbackRequest> callback = _ => { };
        AsyncGPUReadbackRequest first = default;
        for (var i = 0; i < 5; i++)
        {
            first = AsyncGPUReadback.Request(texture, 0, callback);
            Frame();
        }

        var before = GC.GetAllocatedBytesForCurrentThread();
        AsyncGPUReadback.Request(texture, 0, callback);
        Player.Step(1);
        AsyncGPUReadback.Request(texture, 0, callback);
        Player.Step(2);
        var allocated = GC.GetAllocatedBytesForCurrentThread() - before;

        Assert.That(allocated, Is.Zero);
        Assert.That(first.done);
        Assert.That(Player.World.Gpu.PendingReadbacks, Is.Zero);
    }
}
