using System;
using System.Collections.Generic;
using Nowpose.UnityPlayer.Assets;
using UnityEngine;

namespace Nowpose.UnityPlayer;

/// <summary>Plays scenes as a built player does, one frame at a time and in time that the caller gives.</summary>
/// <remarks>
/// While one exists, Unity's static members (Time, Application, Object.Instantiate, …) mean the newest one that was made or stepped. Objects belong
/// to the player they were made in. Main thread only, but for <see cref="Debug"/>.
/// </remarks>
public sealed class Player : IDisposable
{
    readonly PlayerLog _log = new();
    readonly World _world;
    readonly FrameLoop _loop;
    readonly AssetLibrary _assets;
    bool _disposed;

    /// <summary>With an empty scene.</summary>
    /// <param name="assets">Where scenes come from.</param>
    public Player(AssetLibrary assets)
        : this()
    {
        _assets = assets;
    }

    /// <summary>With an empty scene, and without assets.</summary>
    public Player()
    {
        _world = new World(isPlaying: true, _log.Add);
        World.MakeCurrent(_world);
        _loop = new FrameLoop(_world);
    }

    /// <summary>What was written to the console so far, oldest first.</summary>
    public IReadOnlyList<PlayerLogEntry> Logs => _log.Entries;

    /// <summary>Objects that are not destroyed: of scenes, and what scripts made (meshes, materials, …), but no assets.</summary>
    public int ObjectCount => _world.ObjectCount;

    /// <summary>Delegates that hang on the engine's events (Application, Camera, …): what a script forgot to take off.</summary>
    public int SubscriberCount => _world.SubscriberCount;

    internal World World => _world;

    /// <summary>Loads a scene, which becomes the active one; what is active in it wakes.</summary>
    /// <param name="path">As Unity calls it (<c>Assets/Scenes/Demo.unity</c>), or in full.</param>
    /// <param name="prepare">What is to be changed in the scene's root objects before anything in them wakes; null for nothing.</param>
    /// <exception cref="AssetException">There is no such scene, or something in it is broken.</exception>
    public void LoadScene(string path, Action<IReadOnlyList<GameObject>> prepare = null)
    {
        if (_assets == null) throw new InvalidOperationException("this player was made without assets");

        using var scope = _world.Enter();
        var scene = _assets.LoadScene(path);
        prepare?.Invoke(scene.Roots);
        _loop.LoadScene(scene.Name, scene.Path, scene.Roots);
    }

    /// <summary>Takes over objects that are in no scene, as a scene of that name; what is active in them wakes.</summary>
    internal void LoadScene(string name, string path, IReadOnlyList<GameObject> roots)
    {
        using var scope = _world.Enter();
        _loop.LoadScene(name, path, roots);
    }

    /// <summary>Runs one frame at that time, in seconds since the start; it must not go back.</summary>
    public void Step(double timeSeconds)
    {
        if (_disposed) throw new ObjectDisposedException(nameof(Player));

        World.MakeCurrent(_world);
        _loop.Run(timeSeconds);
    }

    /// <summary>A headset's display runs from now on, whose runtime says how long the GPU worked on the newest frame that is done.</summary>
    public void ReportGpuTime(TimeSpan length)
    {
        _world.Gpu.ConnectDisplay();
        _world.Gpu.DisplayGpuTime = (float)length.TotalSeconds;
    }

    /// <summary>The system takes the application to the back, or to the front again.</summary>
    public void Pause(bool paused)
    {
        using var scope = _world.Enter();
        _loop.Pause(paused);
    }

    /// <summary>The window loses or gets the input.</summary>
    public void Focus(bool focused)
    {
        using var scope = _world.Enter();
        _loop.Focus(focused);
    }

    /// <summary>The first active object of that type in the scenes; null where there is none.</summary>
    public T Find<T>() where T : UnityEngine.Object
    {
        using var scope = _world.Enter();
        return UnityEngine.Object.FindObjectOfType<T>();
    }

    /// <summary>Quits: OnApplicationQuit, then everything is disabled and destroyed.</summary>
    public void Dispose()
    {
        if (_disposed) return;

        _disposed = true;
        using (_world.Enter()) _loop.Quit();
        World.Leave(_world);
    }
}
