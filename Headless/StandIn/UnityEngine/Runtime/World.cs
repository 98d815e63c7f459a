namespace UnityEngine;

/// <summary>All state of the engine. Unity's static members use the current world. Only the log may be used from other threads.</summary>
sealed class World
{
    // The world of edit-mode tests. It exists for as long as the process runs.
    static readonly World EditMode = new(isPlaying: false, (type, message, _, _) => Console.WriteLine($"{type}: {message}"));

    static World s_current = EditMode;

    readonly HashSet<Object> _objects = new();
    readonly Action<LogType, string, Exception, Object> _log;
    int _lastId;

    /// <param name="isPlaying">Whether all scripts run. If false, only scripts with the attribute for edit mode run.</param>
    /// <param name="log">
    /// Called with each log entry, from any thread. The exception is null if the entry is a message; the object may be null.
    /// </param>
    internal World(bool isPlaying, Action<LogType, string, Exception, Object> log)
    {
        IsPlaying = isPlaying;
        _log = log;
        Destruction = new Destruction(this);
        Coroutines = new Coroutines(this);
    }

    internal static World Current => s_current;

    internal bool IsPlaying { get; }
    internal Clock Clock { get; } = new();
    internal Scenes Scenes { get; } = new();
    internal Scripts Scripts { get; } = new();
    internal Coroutines Coroutines { get; }
    internal Destruction Destruction { get; }
    internal Host Host { get; } = new();
    internal Rendering.BeforeRender BeforeRender { get; } = new();
    internal Rendering.Cameras Cameras { get; } = new();
    internal Rendering.Gpu Gpu { get; } = new();
    internal Dictionary<string, Shader> Shaders { get; } = new();

    /// <summary>Number of objects that were created in this world and are not destroyed. Assets do not count.</summary>
    internal int ObjectCount => _objects.Count;

    /// <summary>Number of delegates that are subscribed to Unity's events.</summary>
    internal int SubscriberCount => BeforeRender.Count + Cameras.SubscriberCount + Host.SubscriberCount;

    internal IReadOnlyCollection<Object> Objects => _objects;

    /// <summary>Makes this world the current one until the returned scope is disposed.</summary>
    internal WorldScope Enter() => new(this);

    internal bool RunsScript(ScriptType type) => IsPlaying || type.RunsInEditMode;

    /// <summary>Returns a new instance id. As in Unity, ids of objects created at run time are negative.</summary>
    internal int NextId() => --_lastId;

    internal void Register(Object made) => _objects.Add(made);

    internal void Forget(Object destroyed) => _objects.Remove(destroyed);

    internal void Log(LogType type, string message, Exception exception, Object context)
    {
        _log(type, message, exception, context);
        Host.Logged(type, message, exception);
    }

    internal static World MakeCurrent(World world)
    {
        var before = s_current;
        before.Cameras.Suspend();
        s_current = world;
        world.Cameras.Resume();
        return before;
    }

    /// <summary>Makes the world of edit mode the current one if <paramref name="ended"/> is the current world.</summary>
    internal static void Leave(World ended)
    {
        if (ReferenceEquals(s_current, ended)) MakeCurrent(EditMode);
    }
}
