using System;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Unity.Session
{
    /// <summary>
    /// The listeners of an event. An exception of one listener is logged, and the other listeners are called nevertheless: otherwise an error in a
    /// user's script would keep the new state from the components that show it. Allocates only when a listener is added or removed.
    /// </summary>
    /// <typeparam name="T">Type of the event.</typeparam>
    sealed class Listeners<T> where T : Delegate
    {
        T _all;
        T[] _each = Array.Empty<T>();

        public void Add(T listener) => Set((T)Delegate.Combine(_all, listener));

        public void Remove(T listener) => Set((T)Delegate.Remove(_all, listener));

        /// <summary>Calls each listener that is present now, unless an earlier one removes it.</summary>
        /// <param name="sender">Component that raises the event, for the console.</param>
        /// <param name="call">Calls a listener with the value. It must not capture variables, which would allocate.</param>
        public void Raise<TValue>(Component sender, Action<T, TValue> call, TValue value)
        {
            var present = _each;
            foreach (var listener in present)
            {
                // A listener may disable the component of another one.
                if (_each != present && Array.IndexOf(_each, listener) < 0) continue;
                try
                {
                    call(listener, value);
                }
                catch (Exception fault)
                {
                    Debug.LogException(fault, sender);
                }
            }
        }

        void Set(T all)
        {
            _all = all;
            _each = all == null ? Array.Empty<T>() : Array.ConvertAll(all.GetInvocationList(), listener => (T)listener);
        }
    }

    static class ListenerCalls
    {
        public static void Raise(this Listeners<Action> listeners, Component sender) => listeners.Raise(sender, (listener, _) => listener(), false);

        public static void Raise<TValue>(this Listeners<Action<TValue>> listeners, Component sender, TValue value) =>
            listeners.Raise(sender, (listener, given) => listener(given), value);

        /// <summary>Calls the listeners of an event of the Inspector. Logs an exception of a listener; the later ones are then not called.</summary>
        public static void Raise(this UnityEvent listeners, Component sender) => Call(sender, listeners, false, false, (each, _, __) => each.Invoke());

        /// <inheritdoc cref="Raise(UnityEvent, Component)"/>
        public static void Raise<T>(this UnityEvent<T> listeners, Component sender, T value) =>
            Call(sender, listeners, value, false, (each, given, _) => each.Invoke(given));

        /// <inheritdoc cref="Raise(UnityEvent, Component)"/>
        public static void Raise<T1, T2>(this UnityEvent<T1, T2> listeners, Component sender, T1 first, T2 second) =>
            Call(sender, listeners, first, second, (each, one, other) => each.Invoke(one, other));

        // The call captures no variables, which would allocate.
        static void Call<TEvent, T1, T2>(Component sender, TEvent listeners, T1 first, T2 second, Action<TEvent, T1, T2> call)
        {
            try
            {
                call(listeners, first, second);
            }
            catch (Exception fault)
            {
                Debug.LogException(fault, sender);
            }
        }
    }
}
