using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>
    /// Rule that the events of a signal do not switch the signal itself, its object or a parent, because a signal that is switched off raises no event
    /// that could switch it on again.
    /// </summary>
    sealed class SwitchedSignalRule : IShortcomingRule
    {
        public bool IsBrokenBy(Component component) => component is CellSignal signal && SwitchedBy(signal) != null;

        public Shortcoming Shortcoming(Component component) =>
            new Shortcoming(ShortcomingTexts.SwitchesItself(SwitchedBy((CellSignal)component).name), null, null);

        static Object SwitchedBy(CellSignal signal)
        {
            foreach (var each in signal.Events)
                for (var i = 0; i < each.GetPersistentEventCount(); i++)
                    if (Switches(each, i, signal)) return each.GetPersistentTarget(i);
            return null;
        }

        static bool Switches(UnityEventBase raised, int call, CellSignal signal)
        {
            var (target, method) = (raised.GetPersistentTarget(call), raised.GetPersistentMethodName(call));
            if (target == null || raised.GetPersistentListenerState(call) == UnityEventCallState.Off) return false;
            return target is GameObject switched
                ? method == nameof(GameObject.SetActive) && signal.transform.IsChildOf(switched.transform)
                : target == signal && method == "set_enabled";
        }
    }
}
