using UnityEngine;

namespace MixedReality.Toolkit.SpatialManipulation;

public class ConstraintManager : MonoBehaviour
{
}
