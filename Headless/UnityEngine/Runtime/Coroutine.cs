using System.Collections;

namespace UnityEngine;

public sealed class Coroutine : YieldInstruction
{
    object _waitsFor;
    double _due;
    int _frame;

    internal Coroutine(MonoBehaviour owner, IEnumerator routine)
    {
        Owner = owner;
        Routine = routine;
    }

    internal MonoBehaviour Owner { get; }
    internal IEnumerator Routine { get; }
    internal bool Ended { get; private set; }

    internal void End() => Ended = true;

    /// <summary>Whether it goes on later.</summary>
    internal bool MoveNext(Clock clock)
    {
        if (!Routine.MoveNext()) return false;

        _waitsFor = Routine.Current is IEnumerator inner and not CustomYieldInstruction ? Owner.StartCoroutine(inner) : Routine.Current;
        _frame = clock.Frame;
        _due = _waitsFor is WaitForSeconds wait ? clock.Scaled + wait.Seconds : 0;
        return true;
    }

    internal bool IsDue(Clock clock, bool endOfFrame)
    {
        if (_waitsFor is WaitForEndOfFrame) return endOfFrame;
        // At the earliest in the next frame, whatever it waits for.
        if (endOfFrame || clock.Frame == _frame) return false;

        return _waitsFor switch
        {
            WaitForSeconds => clock.Scaled >= _due,
            Coroutine other => other.Ended,
            CustomYieldInstruction custom => !custom.keepWaiting,
            _ => true,
        };
    }
}
