using Nowpose.Samples;
using Nowpose.UnityPlayer;

namespace Nowpose.Prefabs.Pictures;

/// <summary>Plays the sample Virtual Robot Cell in virtual time, with the panel of the HoloLens sample in place of its own.</summary>
sealed class PlayedCell : IDisposable
{
    const double FrameSeconds = 1 / 60.0;

    readonly Clock _clock = new();
    readonly Player _player;
    int _frames;

    public PlayedCell(string root)
    {
        var library = new AssetLibrary(root);
        _player = new Player(library);
        _player.LoadScene(PackagePaths.VirtualScene, roots => Session = roots.SelectMany(r => r.GetComponents<MrilSession>()).Single());
        Session.HeadsetClock = _clock;
        // The session has started with the clock of this machine. Assigning the settings restarts it with the virtual clock.
        Session.Settings = Session.Settings;
        Session.transform.Find("Status Panel").gameObject.SetActive(false);
        Panel = UnityEngine.Object.Instantiate(library.Load<GameObject>(PackagePaths.HoloLensPanel)).GetComponent<StatusPanel>();
        Panel.gameObject.SetActive(false);
        Fields.Set(Panel, "_session", Session);
        Panel.gameObject.SetActive(true);
    }

    public MrilSession Session { get; private set; }

    public StatusPanel Panel { get; }

    public GameObject Real => _player.Find<TruthRig>().gameObject;

    public RobotRig Displayed => Session.transform.Find("Base Anchor/Robot").GetComponent<RobotRig>();

    public GameObject Ghost => Session.transform.Find("Base Anchor/Ghost").gameObject;

    /// <summary>Gets all components of a type in the scene, for example the objects of the cell.</summary>
    public IEnumerable<T> Objects<T>() where T : Component => Session.gameObject.scene.GetRootGameObjects().SelectMany(root => root.GetComponentsInChildren<T>());

    public Transform Head => _player.Find<Camera>().transform;

    /// <summary>Makes the simulated network lose all messages of the control system.</summary>
    public void CutOff() => Fields.Set(_player.Find<SimulatedControlSystem>(), "_loss", 1f);

    public void Run(double seconds)
    {
        for (var end = _frames + seconds / FrameSeconds; _frames < end; _frames++)
        {
            _clock.Set(100 + _frames * FrameSeconds);
            _player.Step(_frames * FrameSeconds);
        }
    }

    public void Dispose() => _player.Dispose();

    sealed class Clock : IHeadsetClock
    {
        HeadsetTime _now;

        /// <summary>The virtual time. Each reading advances it by 1 µs.</summary>
        public HeadsetTime Now => _now += TimeSpan.FromMicroseconds(1);

        public void Set(double seconds) => _now = new HeadsetTime(TimeSpan.FromSeconds(seconds));
    }
}
