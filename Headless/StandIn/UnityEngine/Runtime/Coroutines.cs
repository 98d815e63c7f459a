using System.Collections;

namespace UnityEngine;

/// <summary>Runs the coroutines that scripts have started.</summary>
sealed class Coroutines(World world)
{
    readonly List<Coroutine> _running = new();

    internal int Count => _running.Count;

    internal Coroutine Start(MonoBehaviour owner, IEnumerator routine)
    {
        var made = new Coroutine(owner, routine);
        _running.Add(made);
        Continue(made);
        return made;
    }

    internal void Stop(MonoBehaviour owner, Coroutine routine)
    {
        if (routine != null && ReferenceEquals(routine.Owner, owner)) Stop(routine);
    }

    internal void StopAll(MonoBehaviour owner)
    {
        for (var i = _running.Count - 1; i >= 0; i--)
        {
            if (ReferenceEquals(_running[i].Owner, owner)) Stop(_running[i]);
        }
    }

    /// <summary>
    /// Continues the coroutines that wait for the next frame or for another coroutine. Those that start during this call continue in the next frame.
    /// </summary>
    internal void Update() => Pass(endOfFrame: false);

    internal void EndOfFrame() => Pass(endOfFrame: true);

    void Pass(bool endOfFrame)
    {
        var count = _running.Count;
        for (var i = 0; i < count; i++)
        {
            var routine = _running[i];
            if (!routine.Ended && routine.IsDue(world.Clock.Frame, endOfFrame)) Continue(routine);
        }

        for (var i = _running.Count - 1; i >= 0; i--)
        {
            if (_running[i].Ended) _running.RemoveAt(i);
        }
    }

    void Continue(Coroutine routine)
    {
        try
        {
            if (routine.MoveNext(world.Clock.Frame)) return;
        }
        catch (Exception e)
        {
            Debug.LogException(e, routine.Owner);
        }

        Stop(routine);
    }

    static void Stop(Coroutine routine) => routine.End();
}
