using UnityEngine;
using UnityEngine.Events;

namespace MixedReality.Toolkit.SpatialManipulation;

public class HandConstraint : Solver
{
    [SerializeField] UnityEvent onFirstHandDetected = new();
    [SerializeField] UnityEvent onLastHandLost = new();

    public UnityEvent OnFirstHandDetected
    {
        get => onFirstHandDetected;
        set => onFirstHandDetected = value;
    }

    public UnityEvent OnLastHandLost
    {
        get => onLastHandLost;
        set => onLastHandLost = value;
    }
}
