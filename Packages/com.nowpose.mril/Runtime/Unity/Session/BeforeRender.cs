using System;
using UnityEngine;
using UnityEngine.Events;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Session
{
    /// <summary>Calls an action right before each frame is rendered, and logs its exceptions.</summary>
    /// <remarks>An exception must not leave the handler, because the handlers of other components would then not be called.</remarks>
    sealed class BeforeRender
    {
        readonly Object _context;
        readonly Action _action;
        readonly UnityAction _handler;

        /// <param name="context">Object that is selected by a click on a logged exception.</param>
        public BeforeRender(Object context, Action action)
        {
            _context = context;
            _action = action;
            _handler = Run;
        }

        /// <summary>Whether the action is running now.</summary>
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
