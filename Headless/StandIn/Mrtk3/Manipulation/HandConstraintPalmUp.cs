namespace MixedReality.Toolkit.SpatialManipulation;

public class HandConstraintPalmUp : HandConstraint
{
}
