using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine.InputSystem;

namespace Nowpose.Unity.Tests.Samples;

/// <summary>Plays the scene of the sample with a simulated headset and simulated controllers.</summary>
public abstract class AnyOpenXrHeadsetFixture
{
    const string Scene = "Packages/com.nowpose.mril/Samples~/Any OpenXR headset/Any OpenXR headset.unity";

    private protected PlayedCell _cell;
    private protected MrilSession _session;

    private protected HandPlacedMarker Marker => _session.GetComponentInChildren<HandPlacedMarker>();

    [SetUp]
    public void Begin()
    {
        Controls.Clear();
        _cell = new PlayedCell(RepositoryAssets.NewLibrary());
        _cell.Player.LoadScene(Scene, roots =>
        {
            _session = roots.SelectMany(root => root.GetComponents<MrilSession>()).Single();
            _session.HeadsetClock = _cell.Clock;
        });
        Run(0.1);
    }

    [TearDown]
    public void End()
    {
        _cell.Dispose();
        Controls.Clear();
    }

    private protected void Run(double seconds) => _cell.Run(seconds, _session);

    private protected void Press(string path)
    {
        Controls.Set(path, true);
        Run(0.1);
        Controls.Set(path, false);
        Run(0.1);
    }
}
