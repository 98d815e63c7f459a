using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Rule for the components of the package.</summary>
    interface IShortcomingRule
    {
        bool IsBrokenBy(Component component);

        /// <summary>Returns a description of the problem of a component that breaks the rule.</summary>
        Shortcoming Shortcoming(Component component);
    }

    /// <summary>Something that one or more components lack, and the action of a button in the Inspector that adds it, if there is one.</summary>
    sealed class Shortcoming
    {
        readonly List<Object> _components = new List<Object>();
        readonly Action<Object[]> _fix;

        /// <param name="fixLabel">Label of the button; null if only the user can correct the problem.</param>
        /// <param name="fix">Corrects the problem of the given components. The user can undo it.</param>
        public Shortcoming(string message, string fixLabel, Action<Object[]> fix)
        {
            Message = message;
            FixLabel = fixLabel;
            _fix = fix;
        }

        /// <summary>Message to the user, which names the problem and the remedy.</summary>
        public string Message { get; }

        /// <summary>Label of the button; null if only the user can correct the problem.</summary>
        public string FixLabel { get; }

        /// <summary>Adds another component with the same problem.</summary>
        public void Add(Object component) => _components.Add(component);

        /// <summary>Corrects the problem of all these components.</summary>
        public void Fix() => _fix(_components.ToArray());
    }
}
