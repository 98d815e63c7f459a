using UnityEngine;

namespace MixedReality.Toolkit.SpatialManipulation;

[RequireComponent(typeof(SolverHandler))]
public abstract class Solver : MonoBehaviour
{
}

public class SolverHandler : MonoBehaviour
{
    [SerializeField] bool updateSolvers = true;
}

public class HandConstraintPalmUp : HandConstraint
{
}
