using MixedReality.Toolkit.SpatialManipulation;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;
using UnityEngine.XR.Interaction.Toolkit;

namespace Nowpose.Mrtk3
{
    /// <summary>
    /// Lets the wearer move a marker by hand, by gaze and pinch, or by ray. The robot's base follows the marker from grasp to release.
    /// </summary>
    [AddComponentMenu("Nowpose/Graspable Marker")]
    [DisallowMultipleComponent]
    public sealed class GraspableMarker : MonoBehaviour
    {
        [SerializeField, Tooltip("The marker that is moved by hand. Empty: the marker on this object.")]
        HandPlacedMarker _marker = null;

        [SerializeField, Tooltip("The manipulator that moves the marker. Empty: the manipulator on this object.")]
        ObjectManipulator _manipulator = null;

        [SerializeField, Tooltip("The bounds control whose handles turn the marker. Empty: the bounds control on this object, if any.")]
        BoundsControl _bounds = null;

        int _holds;

        void OnEnable()
        {
            _holds = 0;
            if (_marker == null) _marker = GetComponent<HandPlacedMarker>();
            if (_manipulator == null) _manipulator = GetComponent<ObjectManipulator>();
            if (_bounds == null) _bounds = GetComponent<BoundsControl>();
            if (_marker == null) ConsoleLog.Fail(this, Mrtk3Messages.MarkerWithoutMarker(name));
            if (_manipulator == null) ConsoleLog.Fail(this, Mrtk3Messages.MarkerWithoutManipulator(name));
            if (_manipulator != null)
            {
                _manipulator.firstSelectEntered.AddListener(Grasp);
                _manipulator.lastSelectExited.AddListener(Release);
            }
            if (_bounds == null) return;
            _bounds.ManipulationStarted.AddListener(Grasp);
            _bounds.ManipulationEnded.AddListener(Release);
        }

        void OnDisable()
        {
            if (_manipulator != null)
            {
                _manipulator.firstSelectEntered.RemoveListener(Grasp);
                _manipulator.lastSelectExited.RemoveListener(Release);
            }
            if (_bounds != null)
            {
                _bounds.ManipulationStarted.RemoveListener(Grasp);
                _bounds.ManipulationEnded.RemoveListener(Release);
            }
            if (_holds > 0 && _marker != null) _marker.EndMove();
        }

        void Grasp(SelectEnterEventArgs args)
        {
            if (_holds++ == 0 && _marker != null) _marker.BeginMove();
        }

        // One hand may hold the marker while the other hand turns a handle, so only the last release ends the move.
        void Release(SelectExitEventArgs args)
        {
            if (_holds > 0 && --_holds == 0 && _marker != null) _marker.EndMove();
        }
    }
}
