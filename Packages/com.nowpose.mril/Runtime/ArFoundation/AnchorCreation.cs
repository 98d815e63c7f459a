using System;
using Nowpose.Unity.Messages;
using UnityEngine;
using UnityEngine.XR.ARSubsystems;

namespace Nowpose.ArFoundation
{
    /// <summary>Asks the device for a new anchor until it creates one, because it takes some seconds to scan a new room.</summary>
    /// <remarks>
    /// Asks the subsystem, and not AR Foundation's manager: the manager lists each anchor that the subsystem reports. An anchor that a script adds as a
    /// component is never updated in some versions of AR Foundation, for example in 6.3.0.
    /// </remarks>
    sealed class AnchorCreation
    {
        const float AskEverySeconds = 1;

        readonly Pose _world;
        XRAnchorSubsystem _device;
        double _askAt;
        volatile bool _isAsking;
        bool _isReleased;

        /// <param name="world">Pose of the anchor in the scene.</param>
        public AnchorCreation(Pose world) => _world = world;

        /// <summary>Id of the anchor; invalid until the device has created it. The anchor manager lists the anchor in a later frame.</summary>
        public TrackableId Id { get; private set; }

        /// <summary>Reason why the anchor does not exist yet; null until the device was asked.</summary>
        public string Problem { get; private set; }

        /// <summary>Asks the device if necessary. Call once per frame until the anchor manager lists the anchor.</summary>
        /// <param name="session">Origin of the device's session in the scene.</param>
        public void Follow(XRAnchorSubsystem device, Transform session)
        {
            if (_isAsking || Id != TrackableId.invalidId || Time.unscaledTimeAsDouble < _askAt) return;
            _askAt = Time.unscaledTimeAsDouble + AskEverySeconds;
            _device = device;
            Problem ??= DeviceMessages.AnchorNotCreated;
            Ask(new Pose(session.InverseTransformPoint(_world.position), Quaternion.Inverse(session.rotation) * _world.rotation));
        }

        /// <summary>Removes the anchor from the device, also if the device creates it later.</summary>
        public void Release()
        {
            _isReleased = true;
            if (Id != TrackableId.invalidId && _device.running) _device.TryRemoveAnchor(Id);
        }

        void Take(TrackableId id)
        {
            Id = id;
            if (_isReleased) Release();
        }

#if NOWPOSE_AR_FOUNDATION_6
        // Some devices, such as a Quest, create anchors only asynchronously. The continuation may run on a thread of the provider, or never if the runtime
        // ends.
        async void Ask(Pose pose)
#else
        void Ask(Pose pose)
#endif
        {
            _isAsking = true;
            try
            {
                if (_device.TryAddAnchor(pose, out var anchor)) Take(anchor.trackableId);
#if NOWPOSE_AR_FOUNDATION_6
                else
                {
                    var result = await _device.TryAddAnchorAsync(pose);
                    if (result.status.IsSuccess()) Take(result.value.trackableId);
                }
#endif
            }
            // The type of the exception is the provider's choice, for example OperationCanceledException if the runtime ends.
            catch (Exception fault)
            {
                Problem = DeviceMessages.AnchorRefused(fault.Message);
            }
            _isAsking = false;
        }
    }
}
