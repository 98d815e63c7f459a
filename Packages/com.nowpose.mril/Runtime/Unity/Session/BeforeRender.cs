using System;
using UnityEngine;
using UnityEngine.Events;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Session
{
    /// <summary>Calls an action right before each frame is rendered. The engine calls all handlers of this event in sequence, so exceptions are logged.</summary>
    sealed class BeforeRender
    {
        readonly Object _context;
        readonly Action _action;
        readonly UnityAction _handler;

        /// <param name="context">The object that the console selects when an exception is clicked.</param>
        public BeforeRender(Object context, Action action)
        {
            _context = context;
            _action = action;
            _handler = Run;
        }

        /// <summary>Whether the action is running.</summary>
        public bool IsNow { get; private set; }

        public void Begin() => Application.onBeforeRender += _handler;

        public void End() => Application.onBeforeRender -= _handler;

        void Run()
        {
            IsNow = true;
            try
            {
                _action();
            }
            catch (Exception fault)
            {
                Debug.LogException(fault, _context);
            }
            finally
            {
                IsNow = false;
            }
        }
    }
}
