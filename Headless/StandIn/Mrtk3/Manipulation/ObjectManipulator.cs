using UnityEngine;

namespace MixedReality.Toolkit.SpatialManipulation;

/// <summary>Lets an interactor move its object. In the stand-in, tests move the object.</summary>
[RequireComponent(typeof(ConstraintManager))]
public class ObjectManipulator : StatefulInteractable
{
    [SerializeField] Transform hostTransform;
    [SerializeField] TransformFlags allowedManipulations = TransformFlags.Move | TransformFlags.Rotate | TransformFlags.Scale;

    [SerializeField]
    InteractionFlags allowedInteractionTypes =
        InteractionFlags.Near | InteractionFlags.Ray | InteractionFlags.Gaze | InteractionFlags.Generic;

    public Transform HostTransform
    {
        get => hostTransform == null ? transform : hostTransform;
        set => hostTransform = value;
    }

    public TransformFlags AllowedManipulations
    {
        get => allowedManipulations;
        set => allowedManipulations = value;
    }

    public InteractionFlags AllowedInteractionTypes
    {
        get => allowedInteractionTypes;
        set => allowedInteractionTypes = value;
    }
}
