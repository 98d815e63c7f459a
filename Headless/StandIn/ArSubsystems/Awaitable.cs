using System.Runtime.CompilerServices;
using System.Runtime.ExceptionServices;

namespace UnityEngine;

/// <summary>Awaitable of Unity 2023.1 and newer. It can be awaited once. The continuation runs in the call that completes it.</summary>
public class Awaitable<T>
{
    Action _continuation;
    ExceptionDispatchInfo _fault;
    T _result;
    bool _isCompleted;

    internal Awaitable()
    {
    }

    public Awaiter GetAwaiter() => new(this);

    internal void SetResult(T result)
    {
        _result = result;
        Complete();
    }

    internal void SetException(Exception fault)
    {
        _fault = ExceptionDispatchInfo.Capture(fault);
        Complete();
    }

    void Complete()
    {
        _isCompleted = true;
        _continuation?.Invoke();
    }

    public struct Awaiter : INotifyCompletion
    {
        readonly Awaitable<T> _awaited;

        public Awaiter(Awaitable<T> coroutine) => _awaited = coroutine;

        public bool IsCompleted => _awaited._isCompleted;

        public void OnCompleted(Action continuation)
        {
            if (_awaited._isCompleted) continuation();
            else _awaited._continuation = continuation;
        }

        public T GetResult()
        {
            _awaited._fault?.Throw();
            return _awaited._result;
        }
    }
}
