using System;
using System.Collections.Generic;
using Nowpose.UnityPlayer.Assets;
using UnityEngine;

namespace Nowpose.UnityPlayer;

/// <summary>Plays scenes like a built player, frame by frame and with the caller's time.</summary>
/// <remarks>
/// While a player exists, Unity's static members (Time, Application, Object.Instantiate, …) refer to the one that was created or stepped
/// last. Objects belong to the player in which they were created. Main thread only, except for <see cref="Debug"/>.
/// </remarks>
public sealed class Player : IDisposable
{
    readonly PlayerLog _log = new();
    readonly World _world;
    readonly FrameLoop _loop;
    readonly AssetLibrary _assets;
    bool _disposed;

    /// <summary>Creates a player with an empty scene.</summary>
    /// <param name="assets">Source of the scenes.</param>
    public Player(AssetLibrary assets)
        : this()
    {
        _assets = assets;
    }

    /// <summary>Creates a player with an empty scene and without assets.</summary>
    public Player()
    {
        _world = new World(isPlaying: true, _log.Add);
        World.MakeCurrent(_world);
        _loop = new FrameLoop(_world);
    }

    /// <summary>The entries of the console so far, oldest first.</summary>
    public IReadOnlyList<PlayerLogEntry> Logs => _log.Entries;

    /// <summary>Number of objects that are not destroyed: of scenes, and created by scripts (meshes, materials, …), without assets.</summary>
    public int ObjectCount => _world.ObjectCount;

    /// <summary>Number of delegates subscribed to the engine's events (Application, Camera, …), to find missing unsubscriptions.</summary>
    public int SubscriberCount => _world.SubscriberCount;

    internal World World => _world;

    /// <summary>Loads a scene and makes it the active one. Its active objects wake.</summary>
    /// <param name="path">Path in Unity's form (<c>Assets/Scenes/Demo.unity</c>), or a full path.</param>
    /// <param name="prepare">Changes the scene's root objects before anything in them wakes; null for no changes.</param>
    /// <exception cref="AssetException">The scene does not exist, or is invalid.</exception>
    public void LoadScene(string path, Action<IReadOnlyList<GameObject>> prepare = null)
    {
        if (_assets == null) throw new InvalidOperationException("this player was made without assets");

        using var scope = _world.Enter();
        var scene = _assets.LoadScene(path);
        prepare?.Invoke(scene.Roots);
        _loop.LoadScene(scene.Name, scene.Path, scene.Roots);
    }

    /// <summary>Loads objects that belong to no scene as a scene with this name, and wakes its active objects.</summary>
    internal void LoadScene(string name, string path, IReadOnlyList<GameObject> roots)
    {
        using var scope = _world.Enter();
        _loop.LoadScene(name, path, roots);
    }

    /// <summary>Runs one frame at the given time, in seconds since the start. The time must not decrease.</summary>
    public void Step(double timeSeconds)
    {
        if (_disposed) throw new ObjectDisposedException(nameof(Player));

        World.MakeCurrent(_world);
        _loop.Run(timeSeconds);
    }

    /// <summary>Starts a headset's display, if necessary, and sets the GPU time that its runtime reports for the newest finished frame.</summary>
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

    /// <summary>Gets the first active object of a type in the scenes; null if there is none.</summary>
    public T Find<T>() where T : UnityEngine.Object
    {
        using var scope = _world.Enter();
        return UnityEngine.Object.FindObjectOfType<T>();
    }

    /// <summary>Quits: calls OnApplicationQuit, then disables and destroys all objects.</summary>
    public void Dispose()
    {
        if (_disposed) return;

        _disposed = true;
        using (_world.Enter()) _loop.Quit();
        World.Leave(_world);
    }
}
