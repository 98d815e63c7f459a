using Nowpose.UnityPlayer.Assets;

namespace Nowpose.UnityPlayer;

/// <summary>Plays scenes like a built application, frame by frame, at times that the caller gives.</summary>
/// <remarks>
/// Unity's static members, such as those of Time, Application and Object, refer to the player that was created or stepped last. An object belongs to
/// the player in which it was created. Only <see cref="Debug"/> may be used from other threads.
/// </remarks>
public sealed class Player : IDisposable
{
    readonly PlayerLog _log = new();
    readonly World _world;
    readonly FrameLoop _loop;
    readonly AssetLibrary _assets;
    bool _disposed;

    /// <summary>Creates a player with an empty scene.</summary>
    /// <param name="assets">Library from which the player loads scenes.</param>
    public Player(AssetLibrary assets)
        : this() => _assets = assets;

    /// <summary>Creates a player with an empty scene and without assets.</summary>
    public Player()
    {
        _world = new World(isPlaying: true, _log.Add);
        World.MakeCurrent(_world);
        _loop = new FrameLoop(_world);
    }

    /// <summary>All entries of the console, oldest first.</summary>
    public IReadOnlyList<PlayerLogEntry> Logs => _log.Entries;

    /// <summary>
    /// Number of objects that are not destroyed: objects of scenes, and objects that scripts have created, for example meshes and materials. Assets
    /// do not count.
    /// </summary>
    public int ObjectCount => _world.ObjectCount;

    /// <summary>
    /// Number of delegates that are subscribed to Unity's events, for example those of Application and Camera. Tests use it to find missing
    /// unsubscriptions.
    /// </summary>
    public int SubscriberCount => _world.SubscriberCount;

    internal World World => _world;

    /// <summary>Loads a scene, makes it the active scene, and activates its objects.</summary>
    /// <param name="path">Path within the project (<c>Assets/Scenes/Demo.unity</c>) or an absolute path.</param>
    /// <param name="prepare">
    /// Called with the root objects of the scene before their activation, so that the caller can change them; may be null.
    /// </param>
    /// <exception cref="AssetException">The scene does not exist or is invalid.</exception>
    public void LoadScene(string path, Action<IReadOnlyList<GameObject>> prepare = null)
    {
        if (_assets == null) throw new InvalidOperationException("this player was created without assets");

        using var scope = _world.Enter();
        var scene = _assets.LoadScene(path);
        prepare?.Invoke(scene.Roots);
        _loop.LoadScene(scene.Roots);
    }

    /// <summary>Loads objects that are not in a scene as a new scene, and activates them.</summary>
    internal void LoadScene(IReadOnlyList<GameObject> roots)
    {
        using var scope = _world.Enter();
        _loop.LoadScene(roots);
    }

    /// <summary>Runs one frame.</summary>
    /// <param name="timeSeconds">Time of the frame since the start, s. It must not decrease.</param>
    public void Step(double timeSeconds)
    {
        if (_disposed) throw new ObjectDisposedException(nameof(Player));

        World.MakeCurrent(_world);
        _loop.Run(timeSeconds);
    }

    /// <summary>Starts the headset's display with this refresh rate.</summary>
    public void ConnectDisplay(double hertz)
    {
        _world.Gpu.ConnectDisplay();
        _world.Gpu.DisplayHz = (float)hertz;
    }

    /// <summary>Sets the GPU time that the runtime of the headset's display reports for the last frame. Starts the display if necessary.</summary>
    public void ReportGpuTime(TimeSpan length)
    {
        _world.Gpu.ConnectDisplay();
        _world.Gpu.DisplayGpuTime = (float)length.TotalSeconds;
    }

    /// <summary>Moves the application to the background, or back to the foreground.</summary>
    public void Pause(bool paused)
    {
        using var scope = _world.Enter();
        _loop.Pause(paused);
    }

    /// <summary>Sets whether the window has the input focus.</summary>
    public void Focus(bool focused)
    {
        using var scope = _world.Enter();
        _loop.Focus(focused);
    }

    /// <summary>Returns the first active object of a type in the scenes; null if there is none.</summary>
    public T Find<T>() where T : Object
    {
        using var scope = _world.Enter();
        return Object.FindObjectOfType<T>();
    }

    /// <summary>Ends the application: calls OnApplicationQuit, then disables and destroys all objects.</summary>
    public void Dispose()
    {
        if (_disposed) return;

        _disposed = true;
        using (_world.Enter()) _loop.Quit();
        World.Leave(_world);
    }
}
