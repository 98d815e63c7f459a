using MixedReality.Toolkit;
using MixedReality.Toolkit.SpatialManipulation;
using MixedReality.Toolkit.UX;
using Nowpose.Protocol;
using Nowpose.Unity;
using Nowpose.Unity.Rendering;
using Nowpose.Unity.Tests.Mrtk3;
using Nowpose.UnityPlayer;
using UnityEngine;

namespace Nowpose.Unity.Tests.Samples;

/// <summary>Runs the scene of the HoloLens sample, and simulates the hand of the wearer.</summary>
sealed class PlayedHoloLens : IDisposable
{
    const string ScenePath = "Packages/com.nowpose.mril/Samples~/HoloLens 2 (MRTK3)/HoloLens 2 (MRTK3).unity";

    readonly string _folder;

    public PlayedHoloLens()
    {
        _folder = Directory.CreateTempSubdirectory("nowpose-hololens-").FullName;
        Cell = new PlayedCell(RepositoryAssets.NewLibrary());
        Cell.Player.World.Host.PersistentDataPath = _folder;
        Speech = new SpokenKeywords();
        XRSubsystemHelpers.Provide(Speech);
        Cell.Player.LoadScene(ScenePath, roots => Roots = roots);
        Session = Cell.Player.Find<MrilSession>();
        Session.HeadsetClock = Cell.Clock;
        Session.Settings = PlayedCell.Offline;
        Actions = Cell.Player.Find<CellActions>();
        Run(5);
    }

    public PlayedCell Cell { get; }
    public MrilSession Session { get; }
    public CellActions Actions { get; }
    public SpokenKeywords Speech { get; }
    public IReadOnlyList<GameObject> Roots { get; private set; }

    public void Run(double seconds = 0.1) => Cell.Run(seconds, Session);

    public T Child<T>(string name) where T : Component =>
        Roots.SelectMany(r => r.GetComponentsInChildren<T>(true)).Single(c => c.name == name);

    public void ShowTheHand() => Child<HandConstraintPalmUp>("HandMenuBase").OnFirstHandDetected.Invoke();

    public void Press(string name)
    {
        var button = Child<PressableButton>(name);
        button.Enter();
        button.Exit();
        Run();
    }

    public bool IsOn(string name) => name switch
    {
        "Connect" => Session.IsConnecting,
        "Ghost" => Child<Ghost>("Ghost").Visible,
        "Occlusion" => Actions.IsOcclusionOn,
        _ => Child<StatusPanel>("Status Panel (MRTK3)").gameObject.activeSelf,
    };

    public void Grasp(string name, Action<Transform> move)
    {
        var held = Child<ObjectManipulator>(name);
        held.Enter();
        Run();
        move(held.HostTransform);
        Run(0.5);
        held.Exit();
        Run(1);
    }

    public void Dispose()
    {
        XRSubsystemHelpers.Provide(null);
        Cell.Dispose();
        Directory.Delete(_folder, true);
    }
}
