using System.Collections;

namespace UnityEngine;

public sealed class Coroutine : YieldInstruction
{
    object _waitsFor;
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

    /// <summary>Continues the coroutine to its next yield. Returns false if it has ended.</summary>
    internal bool MoveNext(int frame)
    {
        if (!Routine.MoveNext()) return false;

        _frame = frame;
        _waitsFor = Routine.Current is IEnumerator inner ? Owner.StartCoroutine(inner) : Routine.Current;
        if (_waitsFor is null or WaitForEndOfFrame or Coroutine) return true;

        throw new NotSupportedException($"a coroutine waits for a {_waitsFor.GetType().Name}, which the stand-in does not support");
    }

    internal bool IsDue(int frame, bool endOfFrame)
    {
        if (_waitsFor is WaitForEndOfFrame) return endOfFrame;

        // All other waits last at least until the next frame.
        return !endOfFrame && frame > _frame && (_waitsFor is not Coroutine other || other.Ended);
    }
}

public class YieldInstruction
{
}

public sealed class WaitForEndOfFrame : YieldInstruction
{
}
