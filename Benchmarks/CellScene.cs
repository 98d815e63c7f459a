using System.Reflection;
using System.Runtime.CompilerServices;
using Nowpose.Latency;
using Nowpose.Motion;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Unity;
using Nowpose.UnityPlayer;

namespace Nowpose.Benchmarks;

/// <summary>A scene in the stand-in engine, in virtual time: many instances of the robot cell prefab, each with a simulated plant.</summary>
sealed class CellScene : IDisposable, IHeadsetClock
{
    const double FrameSeconds = 1 / 60.0;
    const string Prefab = "Packages/com.nowpose.mril/Runtime/Prefabs/Nowpose Robot Cell.prefab";

    // The field that a check box in the Inspector sets.
    static readonly FieldInfo ConnectOnEnable =
        typeof(MrilSession).GetField("_connectOnEnable", BindingFlags.Instance | BindingFlags.NonPublic);

    static readonly VirtualCellSettings Plant = new(50, 55, 105, 0, 0, NetworkProfile.Named("wifi"));

    readonly Player _player;
    readonly MrilSession[] _sessions;
    readonly VirtualCell[] _plants;
    long _frame;

    /// <param name="showGhost">Whether each cell also displays the uncompensated pose.</param>
    public CellScene(int cells, bool showGhost)
    {
        var assets = new AssetLibrary(ProjectRoot());
        _player = new Player(assets);
        var prefab = assets.Load<UnityEngine.GameObject>(Prefab);
        // This class delivers the samples, so no cell may connect to a gateway. The cells must stay inactive until their clock is set.
        ConnectOnEnable.SetValue(prefab.GetComponent<MrilSession>(), false);
        prefab.SetActive(false);
        _sessions = [.. Enumerable.Range(0, cells).Select(_ => Cell(prefab, showGhost))];
        _plants = [.. Enumerable.Range(0, cells).Select(Simulate)];
        for (var frame = 0; frame < 60 * 8; frame++) Play();
        foreach (var session in _sessions)
            if (session.Frame.State != PoseState.Current)
                throw new InvalidOperationException("the cell's pose is " + session.Frame.State);
    }

    public HeadsetTime Now { get; private set; } = HeadsetTime.FromSeconds(100);

    /// <summary>Plays the next frame: delivers the samples that are due and runs the player loop.</summary>
    public void Play()
    {
        Receive();
        _player.Step(_frame * FrameSeconds);
    }

    /// <summary>Delivers the samples that are due in the next frame, without running the player loop.</summary>
    public void Receive()
    {
        _frame++;
        Now += TimeSpan.FromSeconds(FrameSeconds);
        for (var i = 0; i < _plants.Length; i++) _plants[i].Run(Now, _sessions[i].Session);
    }

    public void Dispose() => _player.Dispose();

    MrilSession Cell(UnityEngine.GameObject prefab, bool showGhost)
    {
        var session = UnityEngine.Object.Instantiate(prefab).GetComponent<MrilSession>();
        session.HeadsetClock = this;
        session.Settings = new SessionSettings(new ConnectionSettings("127.0.0.1"), new VisualisationLatency(TimeSpan.FromMilliseconds(40)));
        session.GetComponentInChildren<Ghost>(includeInactive: true).Visible = showGhost;
        session.gameObject.SetActive(true);
        return session;
    }

    VirtualCell Simulate(int seed) => new(
        new PickAndPlaceMotion(_sessions[seed].Robot), new VirtualClock(Now, TimeSpan.FromSeconds(1000), 37e-6), Plant, seed, Now);

    // Uses the path of this source file, because BenchmarkDotNet runs a copy that it built in another folder.
    static string ProjectRoot([CallerFilePath] string thisFile = "") => Path.GetFullPath("../..", thisFile);
}
